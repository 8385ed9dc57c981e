"""A local page in the browser: sliders, typed values with units, drawing, margins and curves of one joint.

No physics: the page asks the rooms below and shows what they answer. Starlette and uvicorn are imported only here, when
``asperity serve`` runs.
"""
