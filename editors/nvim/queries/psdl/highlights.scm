; Highlights of PSDL for the tree-sitter parser of Python, which is loaded as `psdl`. Later patterns win.

(identifier) @variable

((identifier) @constant
  (#lua-match? @constant "^[A-Z][A-Z0-9_]+$"))

(attribute attribute: (identifier) @variable.member)
(call function: (identifier) @function.call)
(call function: (attribute attribute: (identifier) @function.method.call))
(keyword_argument name: (identifier) @variable.parameter)
(parameters (identifier) @variable.parameter)
(default_parameter name: (identifier) @variable.parameter)
(lambda_parameters (identifier) @variable.parameter)
(function_definition name: (identifier) @function)
(class_definition name: (identifier) @type)
(decorator "@" @attribute)

; What PSDL adds
((call function: (identifier) @constructor)
  (#any-of? @constructor "Object" "Door" "Window" "Vec"))

((call function: (identifier) @function.builtin)
  (#any-of? @function.builtin
    "set_title" "set_size" "set_floor_asset" "set_wall_asset" "set_coordinate_frame"
    "opposite" "random_direction" "center"))

((identifier) @variable.builtin
  (#any-of? @variable.builtin "scene" "CENTER"))

((identifier) @constant.builtin
  (#any-of? @constant.builtin
    "X_MAX" "X_MIN" "Y_MAX" "Y_MIN" "X_POS" "X_NEG" "Y_POS" "Y_NEG"
    "RIGHT_WALL" "TOP_WALL" "LEFT_WALL" "BOTTOM_WALL"
    "STANDING" "MOUNTED" "WALL_MOUNTED" "FLOATING"))

((attribute attribute: (identifier) @property)
  (#any-of? @property "min" "max" "center" "facing" "width" "depth" "height"))

((call function: (identifier) @function.builtin)
  (#any-of? @function.builtin
    "abs" "all" "any" "bool" "dict" "enumerate" "filter" "float" "int" "len" "list" "map" "max" "min" "print"
    "range" "reversed" "round" "set" "sorted" "str" "sum" "tuple" "zip"))

(integer) @number
(float) @number.float
[(true) (false)] @boolean
(none) @constant.builtin
(string) @string
(escape_sequence) @string.escape
(interpolation "{" @punctuation.special "}" @punctuation.special) @none

(comment) @comment @spell
((comment) @comment.note
  (#lua-match? @comment.note "^#%s*psdl:"))

["(" ")" "[" "]" "{" "}"] @punctuation.bracket
["," "." ":" ";"] @punctuation.delimiter

[
  "+" "-" "*" "/" "//" "%" "**" "@" "=" "+=" "-=" "*=" "/=" "//=" "%=" "**=" "==" "!=" "<" "<=" ">" ">=" "|" "&" "^"
  "~" "<<" ">>" ":=" "->"
] @operator

["and" "or" "not" "in" "is"] @keyword.operator
["def" "lambda"] @keyword.function
["return" "yield"] @keyword.return
["if" "elif" "else" "match" "case"] @keyword.conditional
["for" "while" "break" "continue"] @keyword.repeat
["try" "except" "raise" "finally" "assert"] @keyword.exception
["import" "from" "as"] @keyword.import
["class" "del" "global" "nonlocal" "pass" "with"] @keyword
