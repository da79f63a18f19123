-- The journal's LaTeX numbers figures and tables and knows \autoref; in HTML it is done here. Columns are as wide as what stands in them.
local tables = 0

function RawInline(raw)
  if raw.format == "tex" and raw.text:match("^\\autoref") then return pandoc.Str("Figure 1") end
  if raw.format == "tex" and raw.text:match("^\\label") then return {} end
end

local function numbered(words, caption)
  local first = caption.long[1]
  if first then first.content = pandoc.List({ pandoc.Strong(words), pandoc.Space() }) .. first.content end
  return caption
end

function Figure(figure)
  figure.caption = numbered("Figure 1.", figure.caption)
  return figure
end

function Table(table)
  tables = tables + 1
  table.caption = numbered("Table " .. tables .. ".", table.caption)
  table.colspecs = table.colspecs:map(function(column) return { column[1], nil } end)
  return table
end
