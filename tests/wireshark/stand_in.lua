-- Stands in for Wireshark: runs a dissector under any Lua and prints the trees that it makes.
-- Arguments: the dissector. Input: a line for each packet of a recorded line, its direction (as `p2p_dir`)
-- and its bytes in hex. Output: a line for each item: name, offset, size, kind of text, text.

local function names() return setmetatable({}, {__index = function(_, key) return key end}) end
ftypes, base, frametype, wtap = names(), names(), names(), names()
expert = {group = names(), severity = names()}
ENC_UTF_8, ENC_STRING = 2, 3000000

-- Wireshark wants integers, but takes floats that are whole.
local function whole(number)
  assert(type(number) == "number" and number % 1 == 0, "no integer: " .. tostring(number))
  return number
end

-- Integers of 64 bits are objects, here of two halves.
local Wide = {}
Wide.__index = Wide
function Wide:rshift(count)
  local low, high = self.low, self.high
  for _ = 1, count do low, high = math.floor(low / 2) + high % 2 * 2147483648, math.floor(high / 2) end
  return setmetatable({low = low, high = high}, Wide)
end
function Wide:band(other)
  local bits, low, value = self.low, other.low, 0
  for place = 0, 31 do
    if bits % 2 == 1 and low % 2 == 1 then value = value + 2 ^ place end
    bits, low = math.floor(bits / 2), math.floor(low / 2)
  end
  return setmetatable({low = value, high = 0}, Wide)
end
function Wide:tonumber() return self.high * 4294967296.0 + self.low end
function UInt64(low) return setmetatable({low = whole(low), high = 0}, Wide) end

local function unsigned(bytes, at, size)
  local value = 0
  for place = size - 1, 0, -1 do value = value * 256 + bytes:byte(at + place) end
  return value
end

local function real(bytes, at, size)
  if string.unpack then return (string.unpack(size == 4 and "<f" or "<d", bytes, at)) end
  local top, fraction = size == 4 and 23 or 52, 0
  for place = 0, size - 3 do fraction = fraction + bytes:byte(at + place) * 256 ^ place end
  local high = bytes:byte(at + size - 1) * 256 + bytes:byte(at + size - 2)
  local bits = 8 * size - 1 - top
  local exponent = math.floor(high / 2 ^ (15 - bits)) % 2 ^ bits
  fraction = fraction + high % 2 ^ (15 - bits) * 256 ^ (size - 2)
  local sign, bias = high >= 32768 and -1 or 1, 2 ^ (bits - 1) - 1
  if exponent == 2 ^ bits - 1 then return fraction == 0 and sign / 0 or sign < 0 and 0 / 0 or -(0 / 0) end
  if exponent == 0 then return sign * fraction * 2 ^ (1 - bias - top) end
  return sign * (1 + fraction / 2 ^ top) * 2 ^ (exponent - bias)
end

Struct = {unpack = function(format, bytes, at)
  local kind, size = format:match("^<(%a)(%d?)$")
  if kind == "f" then return real(bytes, at, 4) end
  if kind == "d" then return real(bytes, at, 8) end
  if kind:lower() == "e" then
    return setmetatable({low = unsigned(bytes, at, 4), high = unsigned(bytes, at + 4, 4)}, Wide)
  end
  size = kind:lower() == "b" and 1 or tonumber(size)
  local value = unsigned(bytes, at, size)
  if kind == kind:lower() and value >= 2 ^ (8 * size - 1) then value = value - math.floor(2 ^ (8 * size)) end
  return value
end}

-- Bytes, and ranges of them.
local function range_of(bytes, from, to)
  local range = {at = from}
  function range.len() return to - from end
  return setmetatable(range, {__call = function(_, at, size)
    at = whole(at)
    size = whole(size or to - from - at)
    assert(at >= 0 and size >= 0 and from + at + size <= to, "out of bounds")
    return range_of(bytes, from + at, from + at + size)
  end})
end
local function tvb_of(bytes)
  local tvb = range_of(bytes, 0, #bytes)
  function tvb.raw(_, at, size) return bytes:sub((at or 0) + 1, size and at + size or nil) end
  return tvb
end
ByteArray = {new = function(bytes) return {tvb = function() return tvb_of(bytes) end} end}

local function field(label, filter, bits, names_, mask)
  assert(type(label) == "string" and #filter > 0)
  if mask then assert(whole(mask) < 2 ^ bits) end
  return {name = filter}
end
ProtoField = setmetatable(
  {
    new = function(label, filter) return field(label, filter) end,
    bool = function(filter, label, bits, names_, mask) return field(label, filter, bits, names_, mask) end,
  },
  {__index = function() return function(filter, label) return field(label, filter) end end})
ProtoExpert = {new = function(filter, text) return {name = filter, text = text} end}

local Item = {visible = true, referenced = function() return true end}
Item.__index = Item
local function added(parent, name, at, size, kind, text)
  local item = setmetatable({name = name, at = at, size = size, kind = kind, text = text}, Item)
  parent[#parent + 1] = item
  return item
end
function Item:add(what, range, value)
  if not what.name then return added(self, "_ws.lua.text", what.at, what:len(), "is", range) end
  local kind = value == nil and "" or what.name == "sbgc" and "is" or type(value) == "number" and "number" or "value"
  return added(self, what.name, range.at, range:len(), kind, kind == "number" and string.format("%.17g", value) or value)
end
function Item:add_le(what, range) return added(self, what.name, range.at, range:len(), "") end
function Item:add_packet_field(what, range) return self:add_le(what, range) end
function Item:add_proto_expert_info(what, text) added(self, what.name, 0, 0, "is", text or what.text) end
function Item:set_text(text)
  self.kind, self.text = "is", text
  return self
end
function Item:append_text(text)
  self.kind, self.text = "ends", text
  return self
end
function Item:set_generated() return self end
Item.set_hidden = Item.set_generated

local protocol
function Proto(name)
  protocol = {name = name, prefs = {}, register_heuristic = function() end}
  return protocol
end
Pref = {range = function() return "" end}
local nothing = {add = function() end, add_for_decode_as = function() end}
DissectorTable = {get = function() return nothing end}

local function print_items(items)
  for _, item in ipairs(items) do
    local text = tostring(item.text or ""):gsub("[%c\\\128-\255]", function(c) return string.format("\\x%02x", c:byte()) end)
    print(table.concat({item.name, string.format("%d\t%d", item.at, item.size), item.kind, text}, "\t"))
    print_items(item)
  end
end

dofile(arg[1])
protocol.init()
local number = 0
for line in io.lines() do
  number = number + 1
  local direction, hex = line:match("^(%d) (%x*)$")
  local bytes = hex:gsub("%x%x", function(pair) return string.char(tonumber(pair, 16)) end)
  local root = setmetatable({}, Item)
  protocol.dissector(tvb_of(bytes), {
    number = number, visited = false, rel_ts = number / 1000, p2p_dir = tonumber(direction), cols = {}, src_port = 0, dst_port = 0,
  }, root)
  print_items(root)
end
