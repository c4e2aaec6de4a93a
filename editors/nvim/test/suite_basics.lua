-- What works without anything but the protocol: start, findings, fixes, and what the plugin says about itself.
local t = require('lib')
local test, eventually, equal = t.test, t.eventually, t.equal

test('a .psdl file has the type, the options and a server', function()
  local bufnr, client = t.open(t.scene('lamp.psdl'))
  equal('psdl', vim.bo[bufnr].filetype)
  equal('# %s', vim.bo[bufnr].commentstring)
  equal('psdl', client.server_info.name)
  t.matches('^%d+%.%d+%.%d+', client.server_info.version)
end)

test('a finding stands at its statement, with code and page', function()
  local bufnr = t.open(t.scene('lamp.psdl'))
  t.wait_codes(bufnr, { 'standing' })
  local finding = vim.diagnostic.get(bufnr)[1]
  equal(t.place(bufnr, 'lamp.min.z'), finding.lnum)
  equal(0, finding.col)
  equal(#'lamp.min.z = table.max.z + 0.25', finding.end_col)
  t.matches('lamp floats 0.25 m above table', finding.message)
  equal('psdl', finding.source)
  equal('lamp', finding.user_data.lsp.data.objects[1])
end)

test('findings follow typing, in letters outside of ASCII too', function()
  local bufnr = t.open(t.scene('lamp.psdl'))
  t.wait_codes(bufnr, { 'standing' })
  local row = t.place(bufnr, 'lamp.min.z')
  vim.api.nvim_buf_set_lines(bufnr, row, row + 1, false, { 'größe = "🛋️"; lamp.min.z = table.max.z + 0.3' })
  eventually('the new finding', function()
    local found = vim.diagnostic.get(bufnr)[1]
    return found and found.message:match('0.30 m')
  end)
  local finding = vim.diagnostic.get(bufnr)[1]
  local line = t.lines(bufnr)[row + 1]
  equal('lamp.min.z = table.max.z + 0.3', line:sub(finding.col + 1, finding.end_col))
  vim.api.nvim_buf_set_lines(bufnr, row, row + 1, false, { 'lamp.min.z = table.max.z' })
  t.wait_codes(bufnr, {})
end)

test('what the server believes is what the buffer holds, after many edits', function()
  local bufnr, client = t.open(t.scene('lamp.psdl'))
  for step = 1, 60 do
    local row = (step * 7) % vim.api.nvim_buf_line_count(bufnr)
    if step % 3 == 0 then
      vim.api.nvim_buf_set_lines(bufnr, row, row, false, { '# é🪑' .. step })
    elseif step % 3 == 1 then
      vim.api.nvim_buf_set_text(bufnr, row, 0, row, 0, { 'ü', '𝔸' })
    else
      vim.api.nvim_buf_set_lines(bufnr, row, row + 1, false, {})
    end
    if step % 10 == 0 then
      vim.cmd.undo()
    end
  end
  local answer = t.ask(client, 'psdl/text', { textDocument = vim.lsp.util.make_text_document_params(bufnr) }, bufnr)
  equal(table.concat(t.lines(bufnr), '\n') .. '\n', answer.text)
end)

test('a quick fix mends a misspelt name', function()
  local bufnr = t.open((t.scene('lamp.psdl'):gsub('scene%.center%.x', 'scen.center.x')))
  eventually('the finding', function()
    return vim.list_contains(t.codes(bufnr), 'unknown-name')
  end)
  t.cursor(bufnr, 'scen.center')
  vim.lsp.buf.code_action({
    apply = true,
    filter = function(action)
      return action.isPreferred and action.kind == 'quickfix'
    end,
  })
  eventually('the edit', function()
    return vim.list_contains(t.lines(bufnr), 'table.center.x = scene.center.x')
  end)
  t.wait_codes(bufnr, { 'standing' })
end)

test('Markdown fences go by their quick fix', function()
  local bufnr = t.open('```python\n' .. t.scene('lamp.psdl') .. '```\n')
  eventually('the finding', function()
    return vim.list_contains(t.codes(bufnr), 'markdown-fence')
  end)
  vim.api.nvim_win_set_cursor(0, { 1, 0 })
  vim.lsp.buf.code_action({
    apply = true,
    filter = function(action)
      return action.isPreferred
    end,
  })
  eventually('the edit', function()
    return not table.concat(t.lines(bufnr)):find('```', 1, true)
  end)
end)

test('errors of a template stand in the template', function()
  local bufnr = t.open('box.center.x = 0.5\nbox.center.y = 0.5\n', 'side.psdl')
  local template = '{"width": 5, "depth": 5, "height": 3, "objects": [{"id": "box", "name": "Box", "width": -1, "depth": 1, "height": 1}]}\n'
  local other = t.open(template, 'side.template.json')
  equal('json', vim.bo[other].filetype)
  t.wait_codes(other, { 'template' })
  vim.api.nvim_buf_set_lines(other, 0, -1, false, { (template:gsub('%-1,', '1,'):gsub('\n', '')) })
  t.wait_codes(other, {})
  t.wait_codes(bufnr, {})
end)

test('other files of JSON are left alone', function()
  local path = vim.fs.joinpath(t.folder, 'other.json')
  vim.fn.writefile({ '{}' }, path)
  vim.cmd.edit(path)
  equal('json', vim.bo.filetype)
  t.open(t.scene('lamp.psdl'))
  equal(0, #vim.lsp.get_clients({ bufnr = vim.fn.bufnr(path) }))
end)

test('the status line counts findings', function()
  local bufnr = t.open(t.scene('lamp.psdl'))
  t.wait_codes(bufnr, { 'standing' })
  equal('psdl: 1 error', require('psdl').status(bufnr))
  equal('psdl: 1 error', vim.api.nvim_eval_statusline("%{v:lua.require'psdl'.status()}", {}).str)
  vim.cmd.enew()
  equal('', require('psdl').status())
end)

test('the status line tells of work in progress', function()
  local bufnr, client = t.open(t.scene('lamp.psdl'))
  t.wait_codes(bufnr, { 'standing' })
  local progress = vim.lsp.handlers['$/progress']
  local function tell(value)
    progress(nil, { token = 'here', value = value }, { client_id = client.id, method = '$/progress' })
  end
  tell({ kind = 'begin', title = 'Correcting', percentage = 0 })
  tell({ kind = 'report', message = '3 errors left', percentage = 40 })
  equal('psdl: Correcting 3 errors left 40%', require('psdl').status(bufnr))
  tell({ kind = 'end' })
  equal('psdl: 1 error', require('psdl').status(bufnr))
end)

test(':checkhealth psdl finds nothing wrong', function()
  t.open(t.scene('lamp.psdl'))
  vim.cmd.checkhealth('psdl')
  local report = table.concat(t.lines(0), '\n')
  t.matches('OK psdl %d+%.%d+%.%d+', report)
  t.matches('server %d+%.%d+%.%d+ runs for %d+ buffer', report)
  assert(not report:find('ERROR', 1, true), report)
end)

test(':checkhealth psdl says what to do without a program', function()
  local command = vim.lsp.config.psdl.cmd
  vim.lsp.config('psdl', { cmd = { 'psdl-that-is-not-there', 'lsp' } })
  vim.cmd.checkhealth('psdl')
  local report = table.concat(t.lines(0), '\n')
  vim.lsp.config('psdl', { cmd = command })
  t.matches('ERROR `psdl%-that%-is%-not%-there` is not installed', report)
  t.matches('cargo install psdl', report)
end)

test(':help psdl has its tags', function()
  vim.cmd.helptags(vim.fs.joinpath(t.root, 'editors/nvim/doc'))
  for _, tag in ipairs({ 'psdl', ':PsdlFix', ':PsdlRender', ':PsdlConstants', ':PsdlLog', 'psdl-config' }) do
    vim.cmd.help(tag)
    t.matches('psdl%.txt$', vim.api.nvim_buf_get_name(0), tag)
  end
  vim.fn.delete(vim.fs.joinpath(t.root, 'editors/nvim/doc/tags'))
end)

test(':PsdlLog opens the log', function()
  vim.cmd.PsdlLog()
  equal(vim.lsp.log.get_filename(), vim.api.nvim_buf_get_name(0))
  vim.cmd.tabclose()
end)

test('a server of another version is refused with words', function()
  local bufnr, client = t.open(t.scene('lamp.psdl'))
  local experimental = client.server_capabilities.experimental
  client.server_capabilities.experimental = { psdl = { version = 99 } }
  local words = t.said(function()
    vim.cmd.PsdlFix()
  end)
  client.server_capabilities.experimental = experimental
  equal(1, #words)
  t.matches('does not know this; update this plugin', words[1])
  equal(t.scene('lamp.psdl'), table.concat(t.lines(bufnr), '\n') .. '\n')
end)

test(':PsdlRestart starts the server anew', function()
  local bufnr, client = t.open(t.scene('lamp.psdl'))
  t.wait_codes(bufnr, { 'standing' })
  vim.cmd.PsdlRestart()
  local other = eventually('another server', function()
    local found = vim.lsp.get_clients({ name = 'psdl', bufnr = bufnr })[1]
    return found and found.initialized and found.id ~= client.id and found
  end)
  assert(other.id ~= client.id)
  t.wait_codes(bufnr, { 'standing' })
end)

test('the server ends with the editor', function()
  local _, client = t.open(t.scene('lamp.psdl'))
  client:stop()
  eventually('its end', function()
    return client:is_stopped()
  end)
end)

t.run()
