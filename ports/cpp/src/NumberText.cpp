#include "NumberText.h"

#include <utility>

#include "Guarded.h"
#include "Topics.h"

namespace badlog {

void NumberText::Set(Function function) {
    const std::lock_guard lock{m_mutex};
    if (!function) {
        m_function = nullptr;
        return;
    }
    m_functions.push_back(std::make_unique<Function>(std::move(function)));
    m_function = m_functions.back().get();
}

void NumberText::Write(double value, const Function* function, Topic& topic, RowWriter& row) {
    if (function == nullptr) {
        if (topic.IsXAxis()) {
            row.Microseconds(value);
        } else {
            row.Number(value);
        }
        return;
    }
    Guarded(
        [&] { row.Text((*function)(value)); },
        [&](std::string_view failure) {
            m_faults.CellMissed(topic, "could not be formatted: the DoubleToString function threw ", failure);
            row.Empty();
        });
}

}  // namespace badlog
