package badlog.html

/**
 * A picture that was made from a recording. A page shows it as an image, in which no script can run.
 *
 * @property title what stands above it.
 * @property mediaType `image/svg+xml` or `image/png`.
 * @property bytes the picture. Not to be changed.
 * @throws IllegalArgumentException when [mediaType] is another.
 */
class PageFigure(val title: String, val mediaType: String, val bytes: ByteArray) {
    init {
        require(mediaType in MEDIA_TYPES) { "A figure is ${MEDIA_TYPES.joinToString(" or ")}, not “$mediaType”." }
    }

    private companion object {
        val MEDIA_TYPES = listOf("image/svg+xml", "image/png")
    }
}
