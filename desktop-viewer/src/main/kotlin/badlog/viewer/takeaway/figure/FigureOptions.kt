package badlog.viewer.takeaway.figure

/**
 * What a person may choose about a figure.
 *
 * @property width its width, in points of SVG.
 * @property graphHeight how high one graph's frame is, in points of SVG; lanes take what they need.
 * @property format what kind of file it becomes.
 */
internal data class FigureOptions(val width: Int = 900, val graphHeight: Int = 150, val format: FigureFormat = FigureFormat.PNG)

/**
 * The kinds of file that a figure can be.
 *
 * @property ending how the names of such files end.
 * @property meaning what it is good for.
 */
internal enum class FigureFormat(val ending: String, val meaning: String) {
    PNG("png", "for slides, documents and chats"),
    SVG("svg", "sharp at any size, and can be edited"),
}

/** How many pixels a picture has for each point: sharp in print, and on screens of a high density. */
internal const val PICTURE_SCALE = 2
