// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/geometry/isosurface/field_line.h"

namespace dioptre {

/// Where a field along a stretch changes between inside (less than 0) and outside: the far end of
/// the cell that it lies in.
struct SignChange {
  double s = 0;
  double error = 0;     ///< how far before s it may lie
  bool inside = false;  ///< behind it
};

/// Looks for the sign changes of a field along a stretch, in order.
///
/// A piece of the stretch is left out where the bounds of the value, or the values at its ends with
/// the bounds of the slope, say that the field cannot vanish; it holds one change or none where the
/// slope has one sign; else it is shortened from both ends by the slope (interval Newton; R. E.
/// Moore, 1966) or halved (D. Mitchell, "Robust Ray Intersection with Interval Arithmetic", 1990).
/// Pieces that are shorter than the finest count as changes where the ends differ. What is found
/// alternates whatever the bounds are worth.
///
/// Cells are what halving the stretch over and over gives, of a length below the accuracy, and
/// changes are reported at the far ends of theirs (measured): fine patterns show the difference.
class LineSearch {
 public:
  /// All in s: `steepest` bounds the slope where nothing else does; cells are shorter than
  /// `accuracy`; changes outside `from_to` may be left out.
  struct Options {
    double steepest, finest, accuracy;
    Interval from_to;
  };
  LineSearch(const FieldLine& line, const Options& options);

  /// Whether the ends of the whole stretch are inside.
  bool first_inside() const { return first_inside_; }
  bool last_inside() const { return last_inside_; }

  /// The next change, if there is one.
  bool next(SignChange& out);

  /// Whether the field is inside before the first change that was reported; where none was, at
  /// `from`. To be asked after the first call of next().
  bool began_inside() const { return began_inside_; }

 private:
  struct Piece {
    double low, high;
    double value_low, value_high;
    bool changes() const { return (value_low < 0) != (value_high < 0); }
  };
  enum class Verdict { kEmpty, kOneChange, kDivide };

  Verdict judge(const Piece& piece, Interval& slope) const;
  static bool excluded(const Piece& piece, Interval slope);
  bool shorten(const Piece& piece, Interval slope);
  void divide(const Piece& piece);
  SignChange refine(const Piece& piece) const;

  static constexpr int kDeepest = 64;
  static constexpr int kMostPieces = 4000;
  const FieldLine& line_;
  double steepest_, finest_, cell_;
  Interval from_to_;
  bool first_inside_, last_inside_;
  bool began_ = false, began_inside_ = false;
  int left_ = kMostPieces;  ///< pieces that may still be divided
  int count_ = 0;
  Piece pieces_[kDeepest + 1];  ///< what is still to be searched, the first one last
};

}  // namespace dioptre
