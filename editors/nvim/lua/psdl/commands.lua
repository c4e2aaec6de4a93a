--- The user's commands.
local M = {}

local kinds = { 'out-of-bounds', 'overlap', 'standing', 'mounted', 'clearance', 'facing', 'facing-wall', 'short-side' }
local views = { 'top', 'perspective', 'both' }

---@param words string[]
---@return fun(lead: string): string[]
local function complete(words)
  return function(lead)
    return vim.tbl_filter(function(word)
      return vim.startswith(word, lead)
    end, words)
  end
end

--- Whole lines, as the protocol counts them.
---@param first integer
---@param last integer
---@return lsp.Range
local function lines(first, last)
  return { start = { line = first - 1, character = 0 }, ['end'] = { line = last, character = 0 } }
end

function M.create()
  local command = vim.api.nvim_create_user_command
  command('PsdlFix', function(args)
    require('psdl').fix({
      range = args.range > 0 and lines(args.line1, args.line2) or nil,
      kinds = args.fargs,
      method = args.bang and 'paper' or nil,
    })
  end, { range = true, bang = true, nargs = '*', complete = complete(kinds), desc = 'Correct the layout errors of these lines, or all' })

  command('PsdlRender', function(args)
    local path, view
    for _, word in ipairs(args.fargs) do
      if vim.list_contains(views, word) then
        view = word
      else
        path = vim.fn.expand(word)
      end
    end
    require('psdl').render({ path = path, view = view, open = not args.bang })
  end, {
    nargs = '*',
    bang = true,
    complete = function(lead)
      return vim.list_extend(complete(views)(lead), vim.fn.getcompletion(lead, 'file'))
    end,
    desc = 'Draw the scene into a file and open it',
  })

  command('PsdlConstants', function()
    require('psdl').constants()
  end, { desc = 'Show the constants of the program' })

  command('PsdlMove', function(args)
    require('psdl').move({ to = args.args })
  end, { nargs = '*', desc = 'Move the object of this line to a place, or by a distance' })

  command('PsdlTurn', function(args)
    require('psdl').turn({ facing = args.fargs[1] })
  end, {
    nargs = '?',
    complete = function(lead)
      return complete(require('psdl.place').facings)(lead)
    end,
    desc = 'Turn the object of this line',
  })

  command('PsdlLog', function()
    vim.cmd.tabedit(vim.fn.fnameescape(vim.lsp.log.get_filename()))
    vim.cmd.normal({ 'G', bang = true })
  end, { desc = 'Open the log, at its end' })

  command('PsdlRestart', function()
    -- Not asked to end but ended: it keeps nothing, it may be what hangs, and requests that Neovim still makes would come back as errors.
    vim.lsp.stop_client(vim.lsp.get_clients({ name = 'psdl' }), true)
    vim.lsp.enable('psdl', false)
    vim.wait(5000, function()
      return #vim.lsp.get_clients({ name = 'psdl' }) == 0
    end, 10)
    vim.lsp.enable('psdl', true)
  end, { desc = 'Start the server anew' })
end

return M
