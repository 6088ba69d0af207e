"""Maps of which never more than some rows are at hand.

- map_rows        A map that tells its rows when it is asked for them
- light_in_file   The light of a map on its way into a file, and what was seen of it on the way
"""
