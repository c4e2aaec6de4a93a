---@meta psdl.types
-- What the server and this plugin say to each other; loaded by language servers for Lua only.

---@class psdl.Options What `vim.g.psdl` or `require('psdl').setup` takes.
---@field enable? boolean Start the server for `psdl` buffers. Default: true.
---@field inlay_hints? boolean Show inlay hints. Default: true.
---@field code_lens? boolean Show code lenses and keep them fresh. Default: true.
---@field view? psdl.View What `:PsdlRender` draws. Default: `both`.
---@field theme? 'light'|'dark' The theme of pictures; default: that of 'background'.
---@field step? number Metres by which `:PsdlConstants` nudges a constant. Default: 0.05.

---@class psdl.Settings The section `psdl` of the server's settings.
---@field inlayHints? { coordinates?: boolean, facings?: boolean, parameters?: boolean, loops?: boolean }
---@field hover? { picture?: boolean }
---@field codeLens? boolean
---@field workspaceDiagnostics? boolean

---@alias psdl.View 'top'|'perspective'|'both'
---@alias psdl.Facing 'X+'|'Y+'|'X-'|'Y-'

---@class psdl.Edit
---@field range lsp.Range
---@field newText string
---@field title? string What it does, in words.

---@class psdl.Tally
---@field errors integer Errors of the layout.
---@field loss number Their weighted sum.

---@class psdl.FixResult The answer to `psdl/fix`.
---@field version integer|vim.NIL The version of the document that the edit is for.
---@field edit lsp.WorkspaceEdit
---@field edits psdl.Edit[]
---@field before psdl.Tally
---@field after psdl.Tally
---@field moved integer Objects that move.
---@field transport number Volume times distance, in cubic metres times metres.
---@field evaluations integer Layouts that were tried.

---@class psdl.Constant A number that may be tuned.
---@field range lsp.Range
---@field text string As it stands in the program.
---@field value number
---@field name string|vim.NIL The variable that it is assigned to.
---@field good (number|vim.NIL)[][] Intervals without errors; a null end is open.
---@field moves { path: string, by: number }[] Metres that an object moves for each unit more.
---@field errors integer Errors now among the objects that it moves.

---@class psdl.ConstantsResult The answer to `psdl/constants`.
---@field version integer|vim.NIL
---@field constants psdl.Constant[]

---@class psdl.LayoutObject
---@field path string As the program names it.
---@field name string
---@field center number[] World metres.
---@field facing psdl.Facing

---@class psdl.LayoutResult The answer to `psdl/layout`.
---@field version integer|vim.NIL
---@field layout { objects: psdl.LayoutObject[] }|vim.NIL
---@field ranges { path: string, declaration: lsp.Range|vim.NIL, placements: lsp.Range[] }[] One an object, in the order of the layout.

---@class psdl.Choice One way to reach a place or a facing.
---@field title string
---@field edit lsp.WorkspaceEdit
---@field edits psdl.Edit[]
---@field reached number[]|psdl.Facing World metres of the center, or the facing.
---@field exact boolean Whether what was asked for is reached.
---@field errors integer Errors of the layout afterwards.

---@class psdl.RenderResult The answer to `psdl/render`.
---@field version integer|vim.NIL
---@field stale boolean The picture is of an older text that could be run.
---@field mime string
---@field data string SVG, or a PNG in base64.
---@field objects { path: string, index: integer, range: lsp.Range|vim.NIL }[]
