"""Files of many parts and of unknown size; single files are written by `ground.writing`.

- reading   Files from anywhere: their size is known before they are unpacked; damaged ones are told
- tensors   Bytes of a safetensors file that are the same for the same contents
- headed    Files that begin with a head which is known only when all the rest has been written
- exr_rows  OpenEXR files written some rows at a time
- folders   Folders that appear whole or not at all: stores, whoever begins them first
- leftovers  What runs that were killed have left hidden: swept away by the next run
- contents  A hash of what things hold, so that work is taken up for the same thing alone
"""
