"""Files of many parts and of unknown size; single files are written by `ground.writing`.

- reading   Files from anywhere: their size is known before they are unpacked; damaged ones are told
- folders   Folders that appear whole or not at all: stores, whoever begins them first
- contents  A hash of what things hold, so that work is taken up for the same thing alone
"""
