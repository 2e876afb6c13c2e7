package badlog.window.export.figure

/**
 * What a person may select for a figure.
 *
 * @property width its width, in points of SVG.
 * @property graphHeight the height of one graph's lines, in points of SVG; lanes take what they need.
 * @property format the kind of file.
 */
internal data class FigureOptions(val width: Int = 900, val graphHeight: Int = 150, val format: FigureFormat = FigureFormat.PNG)

/**
 * The kinds of file that a figure can be.
 *
 * @property ending the ending of such files' names.
 * @property meaning what it is good for.
 */
internal enum class FigureFormat(val ending: String, val meaning: String) {
    PNG("png", "for slides, documents and chats"),
    SVG("svg", "sharp at any size, and can be edited"),
}
