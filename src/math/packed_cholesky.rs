//! A Cholesky factor that rows can be appended to and removed from.
//!
//! It serves the active set, where one contact comes or goes at a time:
//! appending and removing cost O(m²) where a new factorisation costs O(m³),
//! and nothing is allocated once the storage has grown to its largest size.
//! It is not a general dense factorisation. The updates are those of Golub and
//! Van Loan (2013), Matrix Computations, section 6.5.

/// The lower factor L of a symmetric positive definite matrix A = L Lᵀ,
/// stored row after row.
#[derive(Clone, Debug, Default)]
pub struct PackedCholesky {
    size: usize,
    rows: Vec<f64>,
}

/// Where row `i` of a packed lower triangle starts.
fn start(i: usize) -> usize {
    i * (i + 1) / 2
}

impl PackedCholesky {
    /// The number of rows.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Forgets every row and keeps the storage.
    pub fn clear(&mut self) {
        self.size = 0;
        self.rows.clear();
    }

    /// Appends a row to A and returns its pivot's square, the Schur
    /// complement of the new diagonal entry.
    ///
    /// `column` are the entries of A against the rows present, `diagonal` the
    /// new diagonal entry. Where the pivot's square does not exceed
    /// `least_pivot` the row depends on those present: nothing is changed and
    /// the pivot's square is returned as `Err`. All in A's unit.
    ///
    /// # Panics
    /// If `column` has not one entry for each row: a bug of the caller.
    pub fn append(&mut self, column: &[f64], diagonal: f64, least_pivot: f64) -> Result<f64, f64> {
        assert_eq!(column.len(), self.size, "one entry a row present");
        let begin = self.rows.len();
        self.rows.extend_from_slice(column);
        self.forward(begin);
        let pivot = diagonal - self.rows[begin..].iter().map(|x| x * x).sum::<f64>();
        if pivot > least_pivot {
            self.rows.push(pivot.sqrt());
            self.size += 1;
            Ok(pivot)
        } else {
            self.rows.truncate(begin);
            Err(pivot)
        }
    }

    /// Removes row and column `index` of A, from 0, by Givens rotations.
    ///
    /// # Panics
    /// If there is no such row: a bug of the caller.
    pub fn remove(&mut self, index: usize) {
        assert!(index < self.size, "row {index} of {}", self.size);
        // Below the removed row every row is one entry too long; rotating
        // neighbouring columns brings the entry above the diagonal to zero.
        for j in index..self.size - 1 {
            let pivot = start(j + 1) + j;
            let (a, b) = (self.rows[pivot], self.rows[pivot + 1]);
            let radius = libm::hypot(a, b);
            let (cosine, sine) = (a / radius, b / radius);
            for i in j + 1..self.size {
                let at = start(i) + j;
                let (x, y) = (self.rows[at], self.rows[at + 1]);
                self.rows[at] = cosine * x + sine * y;
                self.rows[at + 1] = cosine * y - sine * x;
            }
        }
        let mut to = start(index);
        for i in index + 1..self.size {
            let from = start(i);
            self.rows.copy_within(from..from + i, to);
            to += i;
        }
        self.rows.truncate(to);
        self.size -= 1;
    }

    /// Replaces `x` by A⁻¹ x, one entry a row.
    ///
    /// # Panics
    /// If `x` is of another length: a bug of the caller.
    pub fn solve(&self, x: &mut [f64]) {
        assert_eq!(x.len(), self.size, "one entry a row");
        for i in 0..self.size {
            let row = &self.rows[start(i)..start(i) + i + 1];
            let sum: f64 = row[..i].iter().zip(&x[..i]).map(|(l, v)| l * v).sum();
            x[i] = (x[i] - sum) / row[i];
        }
        for i in (0..self.size).rev() {
            let row = &self.rows[start(i)..start(i) + i + 1];
            x[i] /= row[i];
            let value = x[i];
            for (l, v) in row[..i].iter().zip(&mut x[..i]) {
                *v -= l * value;
            }
        }
    }

    /// Replaces the entries stored from `begin` on by L⁻¹ of them.
    fn forward(&mut self, begin: usize) {
        let (factor, x) = self.rows.split_at_mut(begin);
        for i in 0..self.size {
            let row = &factor[start(i)..start(i) + i + 1];
            let sum: f64 = row[..i].iter().zip(&x[..i]).map(|(l, v)| l * v).sum();
            x[i] = (x[i] - sum) / row[i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::PackedCholesky;
    use nalgebra::{DMatrix, DVector};

    /// A positive definite matrix of known condition: Hilbert plus identity.
    fn matrix(size: usize) -> DMatrix<f64> {
        DMatrix::from_fn(size, size, |i, j| {
            1.0 / (1.0 + i as f64 + j as f64) + f64::from(u8::from(i == j))
        })
    }

    fn check_solve(factor: &PackedCholesky, kept: &[usize], full: &DMatrix<f64>) {
        assert_eq!(factor.size(), kept.len());
        let dense = full.select_rows(kept).select_columns(kept);
        let right = DVector::from_fn(kept.len(), |i, _| libm::sin(i as f64 + 1.0));
        let mut x = right.as_slice().to_vec();
        factor.solve(&mut x);
        let residual = &dense * DVector::from_vec(x) - right;
        assert!(residual.amax() < 1e-14, "{kept:?}: {}", residual.amax());
    }

    #[test]
    fn appending_and_removing_in_any_order_keeps_the_factor() {
        let full = matrix(7);
        let mut factor = PackedCholesky::default();
        let mut kept: Vec<usize> = Vec::new();
        let append = |factor: &mut PackedCholesky, kept: &mut Vec<usize>, row: usize| {
            let column: Vec<f64> = kept.iter().map(|&other| full[(row, other)]).collect();
            factor.append(&column, full[(row, row)], 1e-12).unwrap();
            kept.push(row);
        };
        for row in 0..6 {
            append(&mut factor, &mut kept, row);
            check_solve(&factor, &kept, &full);
        }
        for index in [2, 0, 3, 1] {
            factor.remove(index);
            kept.remove(index);
            check_solve(&factor, &kept, &full);
        }
        append(&mut factor, &mut kept, 6);
        append(&mut factor, &mut kept, 0);
        check_solve(&factor, &kept, &full);
    }

    #[test]
    fn a_dependent_row_is_refused_and_changes_nothing() {
        let mut factor = PackedCholesky::default();
        factor.append(&[], 4.0, 1e-12).unwrap();
        assert!(factor.append(&[4.0], 4.0, 1e-12).is_err());
        assert_eq!(factor.size(), 1);
        let mut x = [8.0];
        factor.solve(&mut x);
        assert_eq!(x, [2.0]);
    }
}
