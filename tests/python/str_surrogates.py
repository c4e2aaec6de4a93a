s = "a\ud800b"
print(len(s), repr(s), ascii(s), s[1] == "\ud800", s == "a" + chr(0xD800) + "b", ord(s[1]), s.find("\ud800"), s.replace("\ud800", "-"), s.isprintable(), s < "a\ue000")
try:
    s.encode()
except UnicodeEncodeError as e:
    print(e)
