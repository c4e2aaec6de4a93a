from dataclasses import dataclass, field
from enum import Enum, auto
from typing import Dict, List, Optional
from collections import defaultdict, Counter

class Kind(Enum):
    DEPOSIT = auto()
    WITHDRAW = auto()
    TRANSFER = auto()
class InsufficientFunds(Exception):
    def __init__(self, need, have):
        super().__init__(f"need {need:.2f}, have {have:.2f}")
        self.short = need - have
@dataclass(frozen=True, order=True)
class Event:
    time: int
    kind: Kind = field(compare=False)
    amount: float = field(compare=False, default=0.0)
@dataclass
class Account:
    owner: str
    balance: float = 0.0
    history: List[Event] = field(default_factory=list, repr=False)
    limit: Optional[float] = None
    def apply(self, kind, amount, time):
        if amount <= 0: raise ValueError(f"bad amount {amount}")
        if kind is not Kind.DEPOSIT:
            if amount > self.balance: raise InsufficientFunds(amount, self.balance)
            if self.limit is not None and amount > self.limit: raise PermissionError("over limit")
            amount = -amount
        self.balance = round(self.balance + amount, 2)
        self.history.append(Event(time, kind, amount))
class Bank:
    def __init__(self): self.accounts: Dict[str, Account] = {}; self.log = []; self.clock = 0
    def __getitem__(self, name): return self.accounts.setdefault(name, Account(name))
    def __len__(self): return len(self.accounts)
    def __iter__(self): return iter(self.accounts.values())
    def __contains__(self, name): return name in self.accounts
    def do(self, name, kind, amount, to=None):
        self.clock += 1
        try:
            self[name].apply(kind, amount, self.clock)
            if kind is Kind.TRANSFER: self[to].apply(Kind.DEPOSIT, amount, self.clock)
        except (InsufficientFunds, ValueError) as e:
            self.log.append(f"{self.clock}: {type(e).__name__}: {e}")
            return False
        except PermissionError as e:
            self.log.append(f"{self.clock}: {e}")
            raise RuntimeError("refused") from e
        else:
            return True
        finally:
            self.log.append(f"{self.clock}: {kind.name.lower()} {name}")
bank = Bank()
print(bank.do("ann", Kind.DEPOSIT, 100.10), bank.do("bob", Kind.DEPOSIT, 50), bank.do("ann", Kind.TRANSFER, 30.05, "bob"), bank.do("bob", Kind.WITHDRAW, 500), bank.do("cy", Kind.DEPOSIT, -1))
bank["ann"].limit = 10
try:
    bank.do("ann", Kind.WITHDRAW, 20)
except RuntimeError as e:
    print(e, "because", repr(e.__cause__))
print(*bank.log, sep="\n")
for a in bank: print(a)
print(len(bank), "ann" in bank, "zed" in bank, [a.owner for a in sorted(bank, key=lambda a: -a.balance)], sum(a.balance for a in bank), sorted(bank["bob"].history), max(bank["bob"].history).time)
totals = defaultdict(float)
for a in bank:
    for ev in a.history: totals[ev.kind.name] += ev.amount
print(dict(totals), Counter(ev.kind for a in bank for ev in a.history).most_common(1))
