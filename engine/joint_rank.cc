#include "engine/joint_rank.h"

#include "engine/joint.h"

#include <Eigen/Dense>

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
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), columns);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto add = [&](int body, const Vector3& lever, double sign) {
      if (!moves(body)) return;
      const auto r = static_cast<Eigen::Index>(k);
      matrix.block<1, 3>(r, column(body)) += sign * rows[k].direction.cast<double>().transpose();
      matrix.block<1, 3>(r, column(body) + 3) += sign * lever.cast<double>().transpose();
    };
    add(rows[k].body, rows[k].lever, 1);
    add(rows[k].to, rows[k].to_lever, -1);
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factored(matrix.rows(), matrix.cols());
  factored.setThreshold(std::sqrt(static_cast<double>(epsilon)));
  return static_cast<int>(factored.compute(matrix).rank());
}

}  // namespace cylon::engine
