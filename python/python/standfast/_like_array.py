"""What an array of numpy can do, for what can become one."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import DTypeLike, NDArray


class LikeArray(NDArrayOperatorsMixin):
    """A column that is computed with as an array of numpy is, by becoming one. A null is NaN among numbers.

    The methods have numpy's arguments, by which its functions call them: ``numpy.std(column)`` is ``column.std()``.
    """

    __slots__ = ()

    @abstractmethod
    def to_numpy(self) -> NDArray[Any]: ...

    @abstractmethod
    def __len__(self) -> int: ...

    def __pow__(self, other: Any) -> NDArray[Any]:
        """As of an array, which multiplies where the exponent is small; the function of numpy is another in its last digit."""
        found: NDArray[Any] = self.to_numpy() ** other
        return found

    @property
    def dtype(self) -> np.dtype[Any]:
        """The type of the array of numpy."""
        return self.to_numpy().dtype

    @property
    def shape(self) -> tuple[int]:
        """How many items, in a tuple."""
        return (len(self),)

    @property
    def ndim(self) -> int:
        """One."""
        return 1

    @property
    def size(self) -> int:
        """How many items."""
        return len(self)

    def astype(self, dtype: DTypeLike, **options: Any) -> NDArray[Any]:
        """The values as a numpy array of another type; a null that it cannot show is an error."""
        return np.asarray(self, dtype).astype(dtype, **{"copy": False, **options})

    def copy(self) -> NDArray[Any]:
        """The values as a numpy array, which may be changed."""
        return self.to_numpy()

    def min(self, *args: Any, **options: Any) -> Any:
        """The least value; NaN where one is null."""
        return self.to_numpy().min(*args, **options)

    def max(self, *args: Any, **options: Any) -> Any:
        """The greatest value; NaN where one is null."""
        return self.to_numpy().max(*args, **options)

    def argmin(self, *args: Any, **options: Any) -> Any:
        """The place of the least value."""
        return self.to_numpy().argmin(*args, **options)

    def argmax(self, *args: Any, **options: Any) -> Any:
        """The place of the greatest value."""
        return self.to_numpy().argmax(*args, **options)

    def argsort(self, *args: Any, **options: Any) -> Any:
        """The places of the values as they rise."""
        return self.to_numpy().argsort(*args, **options)

    def sum(self, *args: Any, **options: Any) -> Any:
        """The sum of the values; NaN where one is null."""
        return self.to_numpy().sum(*args, **options)

    def mean(self, *args: Any, **options: Any) -> Any:
        """The mean of the values; NaN where one is null."""
        return self.to_numpy().mean(*args, **options)

    def std(self, *args: Any, **options: Any) -> Any:
        """The standard deviation of the values, over n − ``ddof``, which is 0 as in numpy; NaN where one is null."""
        return self.to_numpy().std(*args, **options)

    def var(self, *args: Any, **options: Any) -> Any:
        """The variance of the values, over n − ``ddof``, which is 0 as in numpy; NaN where one is null."""
        return self.to_numpy().var(*args, **options)

    def cumsum(self, *args: Any, **options: Any) -> Any:
        """The sums of the values up to each of them."""
        return self.to_numpy().cumsum(*args, **options)

    def round(self, *args: Any, **options: Any) -> Any:
        """The values rounded, to so many decimals."""
        return self.to_numpy().round(*args, **options)

    def clip(self, *args: Any, **options: Any) -> Any:
        """The values between two bounds."""
        return self.to_numpy().clip(*args, **options)

    def any(self, *args: Any, **options: Any) -> Any:
        """Whether any value is true, or not zero."""
        return self.to_numpy().any(*args, **options)

    def all(self, *args: Any, **options: Any) -> Any:
        """Whether every value is true, or not zero."""
        return self.to_numpy().all(*args, **options)
