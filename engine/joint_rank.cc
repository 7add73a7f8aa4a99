#include "engine/joint_rank.h"

#include "engine/joint.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

std::optional<int> joint_rank(const Model& model) {
  int count = 0;
  for (const Joint& joint : model.joints) count += row_count(joint.type);
  if (count > most_ranked_rows) return std::nullopt;
  if (count == 0) return 0;
  std::vector<Row> rows;
  for (const Joint& joint : model.joints) add_rows(joint, model.bodies, model.motions.data(), rows);
  std::vector<Eigen::Index> place(model.bodies.size(), -1);
  Eigen::Index columns = 0;
  const auto moves = [&](int body) {
    return body != fixed_world && !model.bodies[static_cast<std::size_t>(body)].locked;
  };
  const auto column = [&](int body) {
    Eigen::Index& at = place[static_cast<std::size_t>(body)];
    if (at < 0) at = columns, columns += 6;
    return at;
  };
  for (const Row& row : rows)
    for (const int body : {row.body, row.to})
      if (moves(body)) column(body);
  if (columns == 0) return 0;
  // Levers of rows of lengths in parts of the longest, so that the rank is that of small and large mechanisms alike.
  double longest = 0;
  const auto is_length = [](const Row& row) { return !row.direction.isZero(0); };
  for (const Row& row : rows)
    if (is_length(row))
      longest = std::max(
          {longest, static_cast<double>(row.lever.norm()), static_cast<double>(row.to_lever.norm())});
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), columns);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double unit = is_length(rows[k]) && longest > 0 ? longest : 1;
    const auto add = [&](int body, const Vector3& lever, double sign) {
      if (!moves(body)) return;
      const auto r = static_cast<Eigen::Index>(k);
      matrix.block<1, 3>(r, column(body)) += sign * rows[k].direction.cast<double>().transpose();
      matrix.block<1, 3>(r, column(body) + 3) += sign / unit * lever.cast<double>().transpose();
    };
    add(rows[k].body, rows[k].lever, 1);
    add(rows[k].to, rows[k].to_lever, -1);
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factored(matrix.rows(), matrix.cols());
  factored.setThreshold(std::sqrt(static_cast<double>(epsilon)));
  return static_cast<int>(factored.compute(matrix).rank());
}

}  // namespace cylon::engine
