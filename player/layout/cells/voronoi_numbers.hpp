#pragma once

#include <boost/polygon/detail/voronoi_ctypes.hpp>
#include <boost/polygon/detail/voronoi_predicates.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace vitrine::player {

/// An integer of up to 2048 bits for the diagram's exact predicates: a sign and 64-bit digits, the lowest
/// first. It is as wide as boost's own.
// Moving is copying. NOLINTNEXTLINE(cppcoreguidelines-special-member-functions)
class WideInt {
  public:
    WideInt() {}  // leaves the digits unset, because most are never used

    // not explicit: boost assigns its integers
    WideInt(std::int64_t value) : is_negative_(value < 0), count_(value != 0 ? 1 : 0) {
        const auto bits = static_cast<std::uint64_t>(value);
        digits_[0] = is_negative_ ? 0 - bits : bits;
    }

    WideInt(const WideInt& other) : is_negative_(other.is_negative_), count_(other.count_) {
        std::copy_n(other.digits_, count_, digits_);
    }

    WideInt& operator=(const WideInt& other) {
        is_negative_ = other.is_negative_;
        count_ = other.count_;
        if (this != &other) std::copy_n(other.digits_, count_, digits_);
        return *this;
    }

    ~WideInt() = default;

    WideInt operator-() const {
        WideInt result(*this);
        result.is_negative_ = !is_negative_;
        return result;
    }

    WideInt operator+(const WideInt& b) const { return sum(*this, b, b.is_negative_); }

    WideInt operator-(const WideInt& b) const { return sum(*this, b, !b.is_negative_); }

    WideInt operator*(const WideInt& b) const;

    /// -1, 0 or 1.
    int sign() const {
        if (count_ == 0) return 0;
        return is_negative_ ? -1 : 1;
    }

    /// Exact to 2^-62 of the value.
    explicit operator long double() const {
        long double value = 0;
        for (std::size_t k = count_; k > 0; --k)
            value = value * 0x1p64L + static_cast<long double>(digits_[k - 1]);
        return is_negative_ ? -value : value;
    }

    explicit operator double() const { return static_cast<double>(static_cast<long double>(*this)); }

  private:
    static constexpr std::size_t max_digits = 32;

    static WideInt sum(const WideInt& a, const WideInt& b, bool b_is_negative) {
        if (a.is_negative_ == b_is_negative)
            return a.count_ < b.count_ ? added(b, a, b_is_negative) : added(a, b, b_is_negative);
        return is_smaller(a, b) ? subtracted(b, a, b_is_negative) : subtracted(a, b, a.is_negative_);
    }

    static bool is_smaller(const WideInt& a, const WideInt& b) {
        if (a.count_ != b.count_) return a.count_ < b.count_;
        for (std::size_t k = a.count_; k > 0; --k)
            if (a.digits_[k - 1] != b.digits_[k - 1]) return a.digits_[k - 1] < b.digits_[k - 1];
        return false;
    }

    /// |a| + |b|. @pre a has at least as many digits as b
    static WideInt added(const WideInt& a, const WideInt& b, bool is_negative) {
        WideInt result;
        result.is_negative_ = is_negative;
        std::uint64_t carry = 0;
        for (std::size_t k = 0; k < a.count_; ++k) {
            const std::uint64_t part = a.digits_[k] + carry;
            const std::uint64_t other = k < b.count_ ? b.digits_[k] : 0;
            result.digits_[k] = part + other;
            carry = part < carry || result.digits_[k] < other ? 1 : 0;
        }
        result.count_ = a.count_;
        if (carry != 0 && result.count_ < max_digits) result.digits_[result.count_++] = carry;
        return result;
    }

    /// |a| - |b|. @pre |a| >= |b|
    static WideInt subtracted(const WideInt& a, const WideInt& b, bool is_negative) {
        WideInt result;
        result.is_negative_ = is_negative;
        std::uint64_t borrow = 0;
        for (std::size_t k = 0; k < a.count_; ++k) {
            const std::uint64_t other = k < b.count_ ? b.digits_[k] : 0;
            const std::uint64_t part = a.digits_[k] - other;
            result.digits_[k] = part - borrow;
            borrow = a.digits_[k] < other || part < borrow ? 1 : 0;
        }
        result.count_ = a.count_;
        result.trim();
        return result;
    }

    void trim() {
        while (count_ > 0 && digits_[count_ - 1] == 0)
            --count_;
    }

    bool is_negative_ = false;
    std::size_t count_ = 0;  // digits, 0 for 0
    std::uint64_t digits_[max_digits];
};

// Digits beyond count_ are never read; gcc does not see that in inlined code.
#ifndef __clang__  // clang does not know the warning
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

inline WideInt WideInt::operator*(const WideInt& b) const {
    __extension__ using Product = unsigned __int128;
    WideInt result;
    result.is_negative_ = is_negative_ != b.is_negative_;
    result.count_ = std::min(count_ + b.count_, max_digits);
    std::fill_n(result.digits_, result.count_, 0);
    for (std::size_t i = 0; i < count_; ++i) {
        std::uint64_t carry = 0;
        std::size_t k = i;
        for (std::size_t j = 0; j < b.count_ && k < result.count_; ++j, ++k) {
            const Product part = Product{digits_[i]} * b.digits_[j] + result.digits_[k] + carry;
            result.digits_[k] = static_cast<std::uint64_t>(part);
            carry = static_cast<std::uint64_t>(part >> 64);
        }
        if (k < result.count_) result.digits_[k] = carry;
    }
    result.trim();
    return result;
}

#ifndef __clang__
#pragma GCC diagnostic pop
#endif

// boost looks these three up by name.

inline bool is_zero(const WideInt& value) {
    return value.sign() == 0;
}

inline bool is_neg(const WideInt& value) {
    return value.sign() < 0;
}

inline bool is_pos(const WideInt& value) {
    return value.sign() > 0;
}

struct ToLongDouble {
    long double operator()(const WideInt& value) const { return static_cast<long double>(value); }
};

/// The numbers that boost's diagram uses if double is not enough. boost's own integers have 32-bit digits.
/// Its own floating type keeps the exponent apart and decomposes each number at every step; long double has a
/// wide enough exponent by itself.
struct VoronoiNumbers : boost::polygon::detail::voronoi_ctype_traits<boost::polygon::detail::int32> {
    using big_int_type = WideInt;
    using efpt_type = long double;
    using to_efpt_converter_type = ToLongDouble;
};

/// The same with rounded numbers instead of exact integers: fast, and rarely far off.
struct RoundingNumbers : VoronoiNumbers {
    using big_int_type = long double;

    struct ToFloating {
        long double operator()(long double value) const { return value; }
    };

    using to_efpt_converter_type = ToFloating;
};

}  // namespace vitrine::player
