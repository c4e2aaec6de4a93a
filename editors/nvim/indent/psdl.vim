" Bodies are indented as in Python.
if exists('b:did_indent')
  finish
endif
runtime! indent/python.vim
