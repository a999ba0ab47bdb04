# Sphinx, for docs/build: Markdown pages, equations by the MathJax that is copied beside them.
project = "asperity"
author = "the asperity authors"
copyright = "GPL-3.0-or-later"
extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 3
# Text between dollars is an equation only in pages that have some; "$5" or a shell's $NAME stands in code.
myst_dmath_allow_space = False
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {
    "messageStyle": "none",
    "showMathMenu": False,
    "SVG": {"scale": 95, "undefinedFamily": "serif"},
    "tex2jax": {"inlineMath": [["\\(", "\\)"]], "displayMath": [["\\[", "\\]"]], "processClass": "math", "ignoreClass": "document"},
}
html_theme = "sphinx_rtd_theme"
html_theme_options = {"navigation_depth": 2, "collapse_navigation": True, "prev_next_buttons_location": "bottom"}
html_static_path = ["static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_show_sourcelink = False
html_copy_source = False
highlight_language = "none"
pygments_style = "default"
smartquotes = False
exclude_patterns = ["static/mathjax/**"]
