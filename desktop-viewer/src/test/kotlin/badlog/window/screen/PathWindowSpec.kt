package badlog.window.screen

import badlog.viewer.draw.path.Field
import badlog.viewer.state.PlaceAction
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import java.awt.BasicStroke
import java.awt.Color
import java.awt.RenderingHints
import java.awt.geom.AffineTransform
import java.awt.geom.Ellipse2D
import java.awt.geom.Line2D
import java.awt.geom.Rectangle2D
import java.awt.image.BufferedImage
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO

@Tags("InCheck")
class PathWindowSpec : FunSpec({
    test("a log with poses starts with its path on the picture of the field beside it").config(
        enabledOrReasonIf = { needsDisplay },
    ) {
        val folder = Files.createDirectory(tempdir().toPath().resolve("Mill Creek"))
        val log = Files.copy(Path.of("../samples/wrong-turn.bag"), folder.resolve("wrong-turn.bag"))
        ImageIO.write(drawnField(), "png", folder.resolve("drawn.png").toFile())
        Files.writeString(
            folder.resolve("field.json"),
            """{"field-image":"drawn.png","field-corners":{"top-left":[$EDGE,$EDGE],"bottom-right":[${EDGE + LENGTH},${EDGE + WIDTH}]},""" +
                """"field-size":[${Field.LENGTH},${Field.WIDTH}],"field-unit":"meter"}""",
        )
        RealWindow(tempdir().toPath(), log).use { window ->
            window.awaitState("the log") { it.current.recording?.fieldPicture != null }
            window.awaitGraphs()
            window.look { it.view.send(PlaceAction.GoTo(DEPARTED)) }
            window.awaitGraphs()
            // The window has nothing similar.
            window.awaitLook("the carpet of the field") { picture ->
                (0 until picture.height).sumOf { y -> (0 until picture.width).count { x -> isGreen(Color(picture.getRGB(x, y))) } } > 10_000
            }
            window.picture("path", guide = "viewer-path")
        }
    }
})

private fun isGreen(color: Color) = color.green > color.red + 12 && color.green > color.blue + 12

/** Returns an invented field: a green carpet, a line and a goal for each alliance, and rings for pieces. */
private fun drawnField(): BufferedImage {
    val picture = BufferedImage(LENGTH + 2 * EDGE, WIDTH + 2 * EDGE, BufferedImage.TYPE_INT_RGB)
    val pen = picture.createGraphics()
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
    pen.color = Color(0x5F6B60)
    pen.fillRect(0, 0, picture.width, picture.height)
    pen.transform = AffineTransform(METER, 0.0, 0.0, METER, EDGE.toDouble(), EDGE.toDouble())
    pen.color = Color(0x9DBB9F)
    pen.fill(Rectangle2D.Double(0.0, 0.0, Field.LENGTH, Field.WIDTH))
    pen.stroke = BasicStroke(0.06f)
    for ((color, at) in listOf(Color(0x2F6FDE) to 0.0, Color(0xD93A3A) to Field.LENGTH)) {
        fun ahead(meters: Double) = if (at == 0.0) meters else at - meters
        pen.color = color
        pen.draw(Line2D.Double(ahead(4.0), 0.0, ahead(4.0), Field.WIDTH))
        pen.draw(Rectangle2D.Double(minOf(at, ahead(1.2)), Field.WIDTH / 2 - 1.1, 1.2, 2.2))
        pen.color = Color(0xE7B84C)
        for (i in 1..4) pen.draw(Ellipse2D.Double(ahead(6.0) - 0.2, Field.WIDTH * i / 5 - 0.2, 0.4, 0.4))
    }
    pen.color = Color.WHITE
    pen.draw(Line2D.Double(Field.LENGTH / 2, 0.0, Field.LENGTH / 2, Field.WIDTH))
    pen.dispose()
    return picture
}

private const val METER = 60.0
private const val EDGE = 30
private const val LENGTH = (Field.LENGTH * METER).toInt()
private const val WIDTH = (Field.WIDTH * METER).toInt()

/** A time in s at which the robot is beside its plan. */
private const val DEPARTED = 9.6
