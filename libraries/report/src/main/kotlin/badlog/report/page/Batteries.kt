package badlog.report.page

import badlog.report.SeasonOfLogs
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.battery.BatteryColumn

/** Returns the table of batteries, with advice; empty if no battery has a name. */
internal fun batteriesPart(batteries: SeasonOfLogs): String {
    if (!batteries.hasNames) return ""
    val columns = BatteryColumn.of(batteries.seasons)
    fun count(column: BatteryColumn) = if (column.isNumber) " class=\"count\"" else ""
    val out = StringBuilder()
    for (advised in BatteryAdvice.of(batteries.seasons).all) {
        out.append("<p><b>${escaped(advised.headline)}.</b> ${escaped(advised.reason)}</p>\n")
    }
    out.append("<div class=\"wide\" role=\"region\" aria-label=\"Batteries\" tabindex=\"0\"><table class=\"batteries\">\n<thead><tr>")
    for (column in columns) out.append("<th scope=\"col\"${count(column)} title=\"${escaped(column.meaning)}\">${column.title}</th>")
    out.append("</tr></thead>\n<tbody>\n")
    for (season in batteries.seasons) {
        out.append("<tr><th scope=\"row\">${escaped(season.title)}</th>")
        for (column in columns.drop(1)) out.append("<td${count(column)}>${escaped(column.text(season) ?: "–")}</td>")
        out.append("</tr>\n")
    }
    return out.append("</tbody>\n</table></div>\n").toString()
}
