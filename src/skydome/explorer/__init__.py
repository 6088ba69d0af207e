"""The explorer: a page on which one drags the sun; its sources are in the repository's folder `explorer/`.

- address  What a sky, a place and a time are called in the page's address
- serving  The page on loopback: served by Python's own `http.server`, to this machine alone
- widget   The page as a widget of notebooks
"""
