--- `:checkhealth psdl`
local M = {}

--- Versions of psdl that go with this plugin: those with the same first two numbers.
M.wanted = '0.1'

---@param command string[]
local function check_program(command)
  local path = vim.fn.exepath(command[1])
  if path == '' then
    vim.health.error(('`%s` is not installed or not in $PATH'):format(command[1]), {
      'Install it with `cargo install psdl`, or take a binary from the releases.',
      "Or say where it is: vim.lsp.config('psdl', { cmd = { '/path/to/psdl', 'lsp' } })",
    })
    return
  end
  local done, answer = pcall(function()
    return vim.system({ path, '--version' }, { text = true, timeout = 5000 }):wait()
  end)
  local version = done and answer.code == 0 and (answer.stdout or ''):match('^psdl (%S+)')
  if not version then
    vim.health.error(('`%s --version` does not answer as psdl does'):format(path))
  elseif not vim.startswith(version, M.wanted .. '.') then
    vim.health.warn(('psdl %s is installed, this plugin goes with %s'):format(version, M.wanted), { 'Update the older of the two.' })
  else
    vim.health.ok(('psdl %s: `%s`'):format(version, path))
  end
end

local function check_clients()
  local clients = vim.lsp.get_clients({ name = 'psdl' })
  if #clients == 0 then
    vim.health.info('no server runs; one is started when a .psdl file is opened')
  end
  for _, client in ipairs(clients) do
    local version = vim.tbl_get(client.server_info or {}, 'version') or 'of an unknown version'
    local buffers = vim.tbl_count(client.attached_buffers)
    vim.health.ok(('server %s runs for %d buffer%s, columns in %s'):format(version, buffers, buffers == 1 and '' or 's', client.offset_encoding))
    if vim.tbl_get(client.server_capabilities, 'experimental', 'psdl', 'version') ~= require('psdl.request').protocol then
      vim.health.warn('the server does not know the commands of this plugin', { 'Update psdl.' })
    end
  end
end

function M.check()
  vim.health.start('psdl')
  if vim.fn.has('nvim-0.11') == 1 then
    vim.health.ok('Neovim ' .. tostring(vim.version()))
  else
    vim.health.error('Neovim 0.11 or newer is needed')
    return
  end
  local config = vim.lsp.config.psdl
  if type(config.cmd) == 'table' then
    check_program(config.cmd --[[@as string[] ]])
  end
  if vim.lsp.is_enabled == nil or vim.lsp.is_enabled('psdl') then
    vim.health.ok('the server is enabled')
  else
    vim.health.warn('the server is not enabled', { "vim.lsp.enable('psdl')" })
  end
  check_clients()
  if require('psdl.highlight').available() then
    vim.health.ok('highlighting through the tree-sitter parser for Python')
  else
    vim.health.info('no tree-sitter parser for Python: the syntax file is used (`:TSInstall python` installs one)')
  end
  vim.health.info('log: `' .. vim.lsp.log.get_filename() .. '`')
end

return M
