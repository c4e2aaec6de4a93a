-- Every feature of the server that Neovim has, and the commands of the plugin.
local t = require('lib')
local test, eventually, equal = t.test, t.eventually, t.equal

--- Opens the scene of the tests and waits for its finding.
local function lamp(text)
  local bufnr, client = t.open(text or t.scene('lamp.psdl'))
  if not text then
    t.wait_codes(bufnr, { 'standing' })
  end
  return bufnr, client
end

local function contents(hover)
  local value = hover.contents
  return type(value) == 'table' and value.value or value
end

--- A server that lacks a feature is a failure here: this plugin and the server are built together.
local function supports(client, method)
  assert(client:supports_method(method), 'the server does not offer ' .. method)
end

test('hover tells about an object', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/hover')
  t.cursor(bufnr, 'lamp.min.z')
  local hover = t.ask(client, 'textDocument/hover', t.position(client), bufnr)
  t.matches('[Ll]amp', contents(hover))
  vim.lsp.buf.hover()
  eventually('a hover window', function()
    return vim.iter(vim.api.nvim_list_wins()):any(function(window)
      return vim.api.nvim_win_get_config(window).relative ~= ''
    end)
  end)
  vim.cmd('silent! fclose!')
end)

test('completion knows objects and their attributes', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/completion')
  vim.api.nvim_buf_set_lines(bufnr, -1, -1, false, { 'lamp.' })
  vim.api.nvim_win_set_cursor(0, { vim.api.nvim_buf_line_count(bufnr), 4 })
  local params = t.position(client)
  params.position.character = 5
  local answer = t.ask(client, 'textDocument/completion', params, bufnr)
  local labels = vim.tbl_map(function(item)
    return item.label
  end, answer.items or answer)
  for _, word in ipairs({ 'center', 'min', 'max', 'facing' }) do
    assert(vim.list_contains(labels, word), word .. ' is not among ' .. vim.inspect(labels))
  end
end)

test('completion through omnifunc inserts a word', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/completion')
  vim.lsp.completion.enable(true, client.id, bufnr, { autotrigger = false })
  vim.api.nvim_buf_set_lines(bufnr, -1, -1, false, { 'lamp.faci' })
  vim.api.nvim_win_set_cursor(0, { vim.api.nvim_buf_line_count(bufnr), 0 })
  equal('v:lua.vim.lsp.omnifunc', vim.bo[bufnr].omnifunc)
  local start = vim.lsp.omnifunc(1, '')
  assert(type(start) == 'number')
end)

test('parameters are shown while a call is typed', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/signatureHelp')
  t.cursor(bufnr, 'Object("Lamp", ', #'Object("Lamp", ')
  local help = t.ask(client, 'textDocument/signatureHelp', t.position(client), bufnr)
  t.matches('Object', help.signatures[1].label)
end)

test('definition goes to the declaration', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/definition')
  t.cursor(bufnr, 'lamp.min.z')
  vim.lsp.buf.definition()
  eventually('the jump', function()
    return vim.api.nvim_win_get_cursor(0)[1] == t.place(bufnr, 'lamp = Object') + 1
  end)
end)

test('references list every use', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/references')
  t.cursor(bufnr, 'gap = 0.05')
  local params = t.position(client)
  params.context = { includeDeclaration = true }
  equal(3, #t.ask(client, 'textDocument/references', params, bufnr))
end)

test('uses of the name under the cursor are highlighted', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/documentHighlight')
  t.cursor(bufnr, 'gap = 0.05')
  equal(3, #t.ask(client, 'textDocument/documentHighlight', t.position(client), bufnr))
end)

test('rename changes every use', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/rename')
  t.cursor(bufnr, 'gap = 0.05')
  vim.lsp.buf.rename('distance')
  eventually('the new name', function()
    local text = table.concat(t.lines(bufnr), '\n')
    return not text:find('gap', 1, true) and select(2, text:gsub('distance', '')) == 3
  end)
end)

test('the outline names the objects', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/documentSymbol')
  local params = { textDocument = vim.lsp.util.make_text_document_params(bufnr) }
  local text = vim.inspect(t.ask(client, 'textDocument/documentSymbol', params, bufnr))
  for _, name in ipairs({ 'table', 'lamp', 'chairs' }) do
    t.matches(name, text)
  end
end)

test('folds come from the server', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/foldingRange')
  vim.wo.foldmethod, vim.wo.foldexpr = 'expr', 'v:lua.vim.lsp.foldexpr()'
  local row = t.place(bufnr, 'for i, chair')
  eventually('a fold', function()
    vim.cmd('silent! normal! zx')
    return vim.fn.foldlevel(row + 2) > 0
  end)
  vim.wo.foldmethod = 'manual'
end)

test('a selection grows with the syntax', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/selectionRange')
  local row, column = t.place(bufnr, '0.25')
  local params = {
    textDocument = vim.lsp.util.make_text_document_params(bufnr),
    positions = { { line = row, character = column } },
  }
  local range = t.ask(client, 'textDocument/selectionRange', params, bufnr)[1]
  equal({ line = row, character = column }, range.range.start)
  assert(range.parent, 'nothing larger')
end)

test('semantic tokens are applied', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/semanticTokens/full')
  local row, column = t.place(bufnr, 'lamp.min.z')
  eventually('a token', function()
    return #(vim.lsp.semantic_tokens.get_at_pos(bufnr, row, column) or {}) > 0
  end)
end)

test('inlay hints are on, and go off by option', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/inlayHint')
  equal(true, vim.lsp.inlay_hint.is_enabled({ bufnr = bufnr }))
  eventually('hints', function()
    return #vim.lsp.inlay_hint.get({ bufnr = bufnr }) > 0
  end)
end)

test('code lenses are shown without being asked for', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/codeLens')
  eventually('lenses', function()
    return #vim.lsp.codelens.get(bufnr) > 0
  end)
end)

test('colours are those of the text', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/documentColor')
  local params = { textDocument = vim.lsp.util.make_text_document_params(bufnr) }
  local colors = t.ask(client, 'textDocument/documentColor', params, bufnr)
  equal(3, #colors)
end)

test('objects of the workspace can be searched', function()
  local bufnr, client = lamp()
  supports(client, 'workspace/symbol')
  local found = eventually('a symbol', function()
    local symbols = t.ask(client, 'workspace/symbol', { query = 'lamp' }, bufnr)
    return symbols and #symbols > 0 and symbols
  end)
  t.matches('lamp', found[1].name)
end)

test('the light bulb offers to correct the error under the cursor', function()
  local bufnr = lamp()
  t.cursor(bufnr, 'lamp.min.z')
  vim.lsp.buf.code_action({
    apply = true,
    context = { only = { 'quickfix' } },
    filter = function(action)
      return action.isPreferred
    end,
  })
  t.wait_codes(bufnr, {})
  equal(false, vim.list_contains(t.lines(bufnr), 'lamp.min.z = table.max.z + 0.25'))
end)

test('the code action to fix all fixes all', function()
  local bufnr = lamp()
  vim.lsp.buf.code_action({ apply = true, context = { only = { 'source.fixAll.psdl' }, diagnostics = {} } })
  t.wait_codes(bufnr, {})
end)

test('the server command to fix all edits the buffer', function()
  local bufnr, client = lamp()
  client:exec_cmd({ title = 'fix', command = 'psdl.server.fixAll', arguments = { vim.uri_from_bufnr(bufnr) } }, { bufnr = bufnr })
  t.wait_codes(bufnr, {})
end)

test(':PsdlFix corrects, says what it did, and one undo takes it back', function()
  local bufnr = lamp()
  local words = t.said(function(words)
    vim.cmd.PsdlFix()
    eventually('a word', function()
      return #words > 0
    end)
  end)
  t.matches('1 edit, errors 1 → 0, 1 object moved', words[1])
  t.wait_codes(bufnr, {})
  vim.cmd.undo()
  equal(t.scene('lamp.psdl'), table.concat(t.lines(bufnr), '\n') .. '\n')
  t.wait_codes(bufnr, { 'standing' })
end)

test(':PsdlFix keeps to its lines and kinds', function()
  local bufnr = lamp()
  local words = t.said(function(words)
    vim.cmd('1,5PsdlFix')
    eventually('a word', function()
      return #words > 0
    end)
    vim.cmd('PsdlFix overlap')
    eventually('another word', function()
      return #words > 1
    end)
  end)
  t.matches('no fix was found', words[1])
  equal(t.scene('lamp.psdl'), table.concat(t.lines(bufnr), '\n') .. '\n')
end)

test(':PsdlFix completes kinds', function()
  equal({ 'standing' }, vim.fn.getcompletion('PsdlFix stan', 'cmdline'))
  assert(vim.list_contains(vim.fn.getcompletion('PsdlRender p', 'cmdline'), 'perspective'))
end)

test(':PsdlRender writes a picture with every object', function()
  lamp()
  local path = vim.fs.joinpath(t.folder, 'picture.svg')
  local words = t.said(function()
    vim.cmd('PsdlRender! top ' .. path)
    eventually('the file', function()
      return vim.fn.filereadable(path) == 1
    end)
  end)
  t.matches('wrote .*picture%.svg', words[1])
  local svg = table.concat(vim.fn.readfile(path), '\n')
  t.matches('<svg', svg)
  for index = 0, 3 do
    t.matches(('data%%-object="%d"'):format(index), svg)
  end
end)

test(':PsdlRender writes a PNG', function()
  lamp()
  local path = vim.fs.joinpath(t.folder, 'picture.png')
  t.said(function()
    vim.cmd('PsdlRender! ' .. path)
    eventually('the file', function()
      return vim.fn.getfsize(path) > 1000
    end)
  end)
  local file = assert(io.open(path, 'rb'))
  equal('\137PNG\r\n\26\n', file:read(8))
  file:close()
end)

test(':PsdlConstants shows constants, follows the text, and changes them', function()
  local bufnr = lamp()
  vim.cmd.PsdlConstants()
  eventually('the window', function()
    return vim.bo.filetype == 'psdlconstants'
  end)
  local window = vim.api.nvim_get_current_buf()
  local function row()
    for number, line in ipairs(t.lines(window)) do
      if line:find('0.25', 1, true) or line:match('^ +14 ') then
        return number, line
      end
    end
  end
  local number, line = row()
  t.matches('lamp', line)
  vim.api.nvim_win_set_cursor(0, { number, 0 })
  vim.api.nvim_feedkeys('3+', 'x', false)
  equal('lamp.min.z = table.max.z + 0.4', t.lines(bufnr)[14])
  eventually('the new value in the window', function()
    return select(2, row()):find('0.4', 1, true)
  end)
  vim.api.nvim_feedkeys('=', 'x', false)
  t.wait_codes(bufnr, {})
  vim.api.nvim_feedkeys('u', 'x', false)
  equal('lamp.min.z = table.max.z + 0.4', t.lines(bufnr)[14])
  eventually('the window after undo', function()
    return select(2, row()):find('0.4', 1, true)
  end)
  vim.api.nvim_feedkeys(vim.keycode('<CR>'), 'x', false)
  equal(bufnr, vim.api.nvim_get_current_buf())
  equal({ 14, #'lamp.min.z = table.max.z + ' }, vim.api.nvim_win_get_cursor(0))
end)

--- Answers what the user would be asked, while something is done.
local function choosing(pattern, body)
  local select, asked = vim.ui.select, {}
  vim.ui.select = function(items, options, done)
    local shown = vim.tbl_map(options.format_item, items)
    asked[#asked + 1] = shown
    for index, text in ipairs(shown) do
      if text:match(pattern) then
        return done(items[index])
      end
    end
    error('not offered: ' .. pattern .. ', only ' .. vim.inspect(shown))
  end
  local done, err = pcall(body)
  vim.ui.select = select
  if not done then
    error(err, 0)
  end
  return asked
end

--- Does something and waits until the plugin has said something about it.
local function answered(body)
  return t.said(function(words)
    body()
    eventually('a word', function()
      return #words > 0
    end)
  end)[1]
end

test(':PsdlMove moves the object of the line, to a place or by a distance', function()
  local bufnr = lamp()
  t.cursor(bufnr, 'lamp.center.x')
  t.matches('Write table.center.x %+ 1.2', answered(function()
    vim.cmd.PsdlMove('x=1.2')
  end))
  equal('lamp.center.x = table.center.x + 1.2', t.lines(bufnr)[12])
  vim.cmd.undo()
  t.cursor(bufnr, 'lamp.center.y')
  local asked = choosing('^Change 0.1 ', function()
    answered(function()
      vim.cmd.PsdlMove('y+0.05')
    end)
  end)
  t.matches('error', asked[1][1])
  equal('lamp.center.y = table.center.y + 0.15', t.lines(bufnr)[13])
end)

test(':PsdlMove asks where to, and which object of a loop', function()
  local bufnr = lamp()
  t.cursor(bufnr, 'chair.max.y = table.min.y - gap')
  local input = vim.ui.input
  local prompt
  vim.ui.input = function(options, done)
    prompt = options.prompt
    done('y=-1')
  end
  choosing('^Change gap', function()
    answered(vim.cmd.PsdlMove)
  end)
  vim.ui.input = input
  t.matches('Move chairs%[0%] %(x=0.00 y=%-0.70', prompt)
  eventually('the new gap', function()
    return vim.list_contains(t.lines(bufnr), 'gap = 0.35')
  end)
  t.cursor(bufnr, 'chair.center.x = ')
  local asked = choosing('chairs%[1%]', function()
    answered(function()
      vim.cmd.PsdlMove('nowhere')
    end)
  end)
  equal({ 'chairs[0]', 'chairs[1]' }, asked[1])
end)

test(':PsdlTurn turns the object of the line', function()
  local bufnr = lamp()
  t.cursor(bufnr, 'lamp.facing')
  t.matches('X_MAX', answered(function()
    vim.cmd.PsdlTurn('X+')
  end))
  equal('lamp.facing = X_MAX', t.lines(bufnr)[15])
  local asked = choosing('^Y%+', function()
    answered(vim.cmd.PsdlTurn)
  end)
  equal({ 'X+ (now)', 'Y+', 'X-', 'Y-' }, asked[1])
  equal('lamp.facing = Y_MAX', t.lines(bufnr)[15])
  equal({ 'X+', 'X-' }, vim.fn.getcompletion('PsdlTurn X', 'cmdline'))
end)

test('an edit that is made for an older text is not applied', function()
  local bufnr = lamp()
  t.cursor(bufnr, 'lamp.facing')
  local words = t.said(function(words)
    local select = vim.ui.select
    vim.ui.select = function(items, _, done)
      vim.api.nvim_buf_set_lines(bufnr, 0, 0, false, { '# a line above' })
      done(items[1])
    end
    t.cursor(bufnr, 'lamp.min.z')
    vim.cmd.PsdlMove('z=0.95')
    eventually('a word', function()
      return #words > 0
    end)
    vim.ui.select = select
  end)
  t.matches('the text has changed meanwhile; nothing was done', words[1])
  equal('# a line above\n' .. t.scene('lamp.psdl'), table.concat(t.lines(bufnr), '\n') .. '\n')
end)

--- Lets the server answer that a request was overtaken, so often; how often it was asked, and what the user was told.
local function overtaken(client, times, meanwhile)
  local request, asked = client.request, 0
  client.request = function(self, method, params, handler, bufnr)
    asked = asked + (method == 'psdl/fix' and 1 or 0)
    if method ~= 'psdl/fix' or asked > times then
      return request(self, method, params, handler, bufnr)
    end
    meanwhile()
    handler({ code = -32801, message = 'content modified' })
    return true, asked
  end
  local word = answered(vim.cmd.PsdlFix)
  client.request = request
  return asked, word
end

test('a request that an edit overtook is no error', function()
  local bufnr, client = lamp()
  local asked, word = overtaken(client, 9, function()
    vim.api.nvim_buf_set_lines(bufnr, 0, 0, false, { '# a line above' })
  end)
  equal(1, asked)
  equal('psdl: the text has changed meanwhile; nothing was done', word)
end)

test('a request that something else overtook is made again', function()
  local bufnr, client = lamp()
  local asked, word = overtaken(client, 2, function() end)
  equal(3, asked)
  t.matches('errors 1 → 0', word)
  t.wait_codes(bufnr, {})
end)

test('where an object shall go is read from words', function()
  local target = require('psdl.place').target
  local here, stays = { 1, 2, 3 }, vim.NIL
  equal({ 4, 5, -6 }, target('4 5 -6', here))
  equal({ 1.5, stays, 2.75 }, target('x+0.5, z-0.25', here))
  equal({ stays, -1, stays }, target('Y=-1', here))
  for _, text in ipairs({ '', '1 2', 'w=1', 'x=1 x=2', 'x=', 'x=1.2.3' }) do
    equal(nil, target(text, here), text)
  end
end)

test('a number is written as Python writes a float', function()
  local literal = require('psdl.constants').literal
  equal('1.0', literal(1))
  equal('-0.05', literal(-0.05))
  equal('0.0', literal(-0.0000001))
  equal('0.3', literal(0.1 + 0.2))
  equal('1200.5', literal(1200.5))
end)

test('the nearest value without errors lies just inside its interval', function()
  local nearest = require('psdl.constants').nearest
  local open = vim.NIL
  equal(nil, nearest({ value = 1, good = { { 0, 2 } } }))
  equal(0.01, nearest({ value = -1, good = { { 0, 2 } } }))
  equal(0.0, nearest({ value = 0.25, good = { { -0.00998, 0.0099976 } } }))
  equal(0.35, nearest({ value = 1, good = { { 0.332, 0.3611 } } }))
  equal(1.99, nearest({ value = 5, good = { { 0, 2 }, { 9.5, open } } }))
  equal(nil, nearest({ value = 5, good = {} }))
end)

test('settings reach the server', function()
  local bufnr, client = lamp()
  supports(client, 'textDocument/inlayHint')
  eventually('hints', function()
    return #vim.lsp.inlay_hint.get({ bufnr = bufnr }) > 0
  end)
  client.settings.psdl.inlayHints = { coordinates = false, facings = false, parameters = false, loops = false }
  client:notify('workspace/didChangeConfiguration', { settings = client.settings })
  eventually('no hints', function()
    local params = {
      textDocument = vim.lsp.util.make_text_document_params(bufnr),
      range = { start = { line = 0, character = 0 }, ['end'] = { line = vim.api.nvim_buf_line_count(bufnr), character = 0 } },
    }
    return #(t.ask(client, 'textDocument/inlayHint', params, bufnr) or {}) == 0
  end)
end)

t.run()
