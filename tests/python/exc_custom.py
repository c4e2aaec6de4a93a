class AppError(Exception):
    def __init__(self, code, **details):
        super().__init__(code, details)
        self.code = code
    def __str__(self):
        return f"[{self.code}] {self.args[1]}"
try:
    raise AppError(7, why="test")
finally:
    print("finally runs")
