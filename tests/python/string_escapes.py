cases = ["\a\b\t\n\v\f\r", "\0", "\x00\x1f\x7f\x80\xff", "\u0100\uffff", "\U0001F600", "\101\60\7", "\\", "\'", '\"', "'", '"', "'\"", "\N{GREEK SMALL LETTER ALPHA}\N{SNOWMAN}", "a\
b", r"\n\t\\", r"a\"b", R"\x41", "line1\nline2", """tri"ple''' """, '''a
b''', "" "", "a" 'b' """c""", "\xe9", "\u200b\u200e", "\xad", "\u2028", "tab\there", "\x1b[0m", "é", "日本", "\ufeff", "\u00a0", "\\x41", "\\u0041", "\1234"]
for c in cases: print(len(c), repr(c), ascii(c), [ord(x) for x in c][:12])
bs = [b"\x00\xff", b"\n\t\\", b"'", b'"', b"'\"", rb"\x41", br"\n", b"\101", b"a" b"b", b"", bytes(range(256))]
for b in bs: print(len(b), b)
print("%r %a" % ("é\n", "é\n"), "{!r} {!a}".format("☃", "☃"), repr("\\"), repr("\\'"), repr(r"\d+"), str("\n") == "\n", "\x41" == "A" == "\u0041" == "\101", len("\\n"), len(r"\n"), len("\n"), "\n" in """
""", u"x" == "x")
print(repr("a'b"), repr('a"b'), repr('a\'b"c'), repr("tab\t"), repr("\u0378"), repr("\U0010ffff"), repr("\ue000"), repr("e\u0301"), "e\u0301" == "é", len("e\u0301"), "\u00df".upper(), repr("\x85"), repr("\u3000"), repr("\U0001F468\u200D\U0001F469"))
