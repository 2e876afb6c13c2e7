package badlog.window.export.figure

/**
 * A person's options for a figure.
 *
 * @property width its width, in points of SVG.
 * @property graphHeight the height of one graph's lines, in points of SVG; lanes add their own height.
 * @property format the kind of file.
 */
internal data class FigureOptions(val width: Int = 900, val graphHeight: Int = 150, val format: FigureFormat = FigureFormat.PNG)

/**
 * The kinds of file for a figure.
 *
 * @property ending the ending of such files' names.
 * @property meaning its purpose, for people.
 */
internal enum class FigureFormat(val ending: String, val meaning: String) {
    PNG("png", "for slides, documents and chats"),
    SVG("svg", "sharp at any size, and can be edited"),
}
