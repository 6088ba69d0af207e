"""What numbers and sizes may be, told before they are used.

- ranges  The intervals in which numbers may lie, declared by the classes that take them
- sizes   How much memory a piece of work may take, asked before it begins
"""
