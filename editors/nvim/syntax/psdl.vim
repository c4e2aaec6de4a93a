" PSDL on top of Python: used where no tree-sitter parser for Python is installed.
if exists('b:current_syntax')
  finish
endif
runtime! syntax/python.vim
unlet! b:current_syntax

syn keyword psdlConstructor Object Door Window Vec
syn keyword psdlFunction set_title set_size set_floor_asset set_wall_asset set_coordinate_frame
syn match psdlFunction /\.\@1<!\<\%(opposite\|random_direction\|center\)\>\ze(/
syn keyword psdlScene scene CENTER
syn keyword psdlDirection X_MAX X_MIN Y_MAX Y_MIN X_POS X_NEG Y_POS Y_NEG
syn keyword psdlDirection RIGHT_WALL TOP_WALL LEFT_WALL BOTTOM_WALL
syn keyword psdlSupport STANDING MOUNTED WALL_MOUNTED FLOATING
syn match psdlAnchor /\.\@1<=\%(min\|max\|center\|facing\|width\|depth\|height\)\>/
syn match psdlConstant /\<\d\+\.\d*\%([eE][-+]\=\d\+\)\=\|\.\d\+\%([eE][-+]\=\d\+\)\=\>/
syn match psdlIgnore /#\s*psdl:.*$/ contained containedin=pythonComment

hi def link psdlConstructor Type
hi def link psdlFunction Function
hi def link psdlScene Identifier
hi def link psdlDirection Constant
hi def link psdlSupport Constant
hi def link psdlAnchor Special
hi def link psdlConstant Float
hi def link psdlIgnore SpecialComment

let b:current_syntax = 'psdl'
