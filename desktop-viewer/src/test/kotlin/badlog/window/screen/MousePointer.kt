package badlog.window.screen

import java.awt.Color
import java.awt.Polygon
import java.awt.RenderingHints
import java.awt.image.BufferedImage

/** Draws a mouse pointer into [picture] with its tip at ([x], [y]): pictures of a screen lack it. */
internal fun drawPointer(picture: BufferedImage, x: Int, y: Int) {
    val shape = Polygon(intArrayOf(0, 0, 4, 7, 10, 7, 12), intArrayOf(0, 17, 13, 20, 19, 12, 12), 7).apply { translate(x, y) }
    with(picture.createGraphics()) {
        setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
        color = Color.BLACK
        fillPolygon(shape)
        color = Color.WHITE
        drawPolygon(shape)
        dispose()
    }
}
