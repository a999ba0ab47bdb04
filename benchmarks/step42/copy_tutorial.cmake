# Copies or unpacks the tutorial's source from INPUT to OUTPUT. VARIANT step_42: as it is; step_42_free_sides: the cube's four
# sides carry no condition, which is what asperity's block has.
if(INPUT MATCHES "\\.gz$")
  execute_process(COMMAND gzip -dc ${INPUT} OUTPUT_FILE ${OUTPUT} COMMAND_ERROR_IS_FATAL ANY)
else()
  configure_file(${INPUT} ${OUTPUT} COPYONLY)
endif()
if(VARIANT STREQUAL "step_42_free_sides")
  execute_process(COMMAND grep -c "set_boundary_id(8)" ${OUTPUT} OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT found EQUAL 1)
    message(FATAL_ERROR "${INPUT} is not the tutorial of deal.II 9.4: its cube's sides are not marked where expected")
  endif()
  execute_process(COMMAND sed -i "s/set_boundary_id(8)/set_boundary_id(0)/" ${OUTPUT} COMMAND_ERROR_IS_FATAL ANY)
endif()
