chair_width = 0.5
def total(): return chair_widht * 2
print(chair_width)
total()
