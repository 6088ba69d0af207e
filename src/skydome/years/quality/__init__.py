"""How good a weather file's light is: what is missing, impossible or unlikely in it, and its repair.

- clear_sky      Clear-sky irradiances that measured ones are held against
- checks         What is wrong with single hours, as flags
- report         The report of a whole record: counts, closure, clearness, variability, turbidity
- repairs        Repairs of what is wrong, each flagged
- repaired_file  The repaired record as a file, in which each repair is told
"""
