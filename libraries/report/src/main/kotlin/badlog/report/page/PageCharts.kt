package badlog.report.page

/**
 * A chart of all logs, for the index page and as files beside it.
 *
 * @property name its name in names of files: lower-case letters and `-`.
 * @property title its title.
 * @property question the question that it answers.
 * @property reading an explanation for reading it.
 * @property svg the chart as a document of SVG.
 * @property png the chart as a picture.
 */
class PageChart(val name: String, val title: String, val question: String, val reading: String, val svg: String, val png: ByteArray)

/**
 * The charts of a report.
 *
 * @property all the charts that were drawn.
 * @property lacking the missing data for each of the others, as a sentence.
 * @property undrawn the names of the others.
 */
class PageCharts(val all: List<PageChart>, val lacking: List<String>, val undrawn: List<String> = emptyList()) {
    companion object {
        /** No charts, for a report without them. */
        val NONE: PageCharts = PageCharts(emptyList(), emptyList())

        /** The folder of their files, beside the index. */
        internal const val FOLDER = "charts"
    }
}

/** Returns the part of the index page with [charts]. Each is a picture in a file beside the page; for others, the missing data is named. */
internal fun chartsPart(charts: PageCharts): String {
    val out = StringBuilder()
    if (charts.all.isNotEmpty()) out.append("<div class=\"charts\">\n")
    for (chart in charts.all) {
        val file = "${PageCharts.FOLDER}/${chart.name}"
        val said = escaped("${chart.title}. ${chart.question} ${chart.reading}")
        out.append(
            "<figure id=\"chart-${chart.name}\"><a href=\"$file.svg\"><img src=\"$file.svg\" alt=\"$said\" width=\"900\" height=\"420\"></a>\n",
        )
        val links = "<a href=\"$file.svg\">SVG</a> <a href=\"$file.png\">PNG</a>"
        out.append("<figcaption>${escaped(chart.title)} <small>$links</small></figcaption></figure>\n")
    }
    if (charts.all.isNotEmpty()) out.append("</div>\n")
    if (charts.lacking.isNotEmpty()) {
        out.append(charts.lacking.joinToString("", "<ul class=\"notes\">\n", "</ul>\n") { "<li>${escaped(it)}</li>\n" })
    }
    return out.toString()
}
