package badlog.window.graph.xy

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.toPixelMap
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.ScrollWheel
import androidx.compose.ui.test.doubleClick
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performMultiModalInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.path.xScale
import badlog.viewer.draw.path.yScale
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.change
import badlog.window.graph.TestGraphs
import badlog.window.graph.sample
import badlog.window.graph.savePicture
import badlog.window.graph.viewerOf
import badlog.window.graph.waitForPictures
import badlog.window.log.OpenRecording
import badlog.window.theme.Palette
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import java.awt.image.BufferedImage
import java.io.File
import java.nio.file.Files
import javax.imageio.ImageIO

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class XyPaneSpec : FunSpec({
    val recording by lazy { sample("wrong-turn.bag") }

    /** Runs [test] over the path of the sample. */
    fun path(test: DesktopComposeUiTest.(Viewer) -> Unit) = runDesktopComposeUiTest(1100, 700) {
        val viewer = viewerOf(recording)
        viewer.board.replace(recording.standardGraphs)
        setContent { TestGraphs(viewer) }
        waitForPictures(viewer)
        test(viewer)
    }

    fun DesktopComposeUiTest.plot() = onNodeWithContentDescription("Plot Path")

    fun ImageBitmap.count(color: Color) = toPixelMap().buffer.count { Color(it) == color }

    test("a log with poses begins with its driven, planned and estimated path, the largest error, and the robot at the cursor") {
        path { viewer ->
            viewer.board.state.graphs[0].isXy shouldBe true
            viewer.view.send(PlaceAction.MoveCursor(9.4))
            waitForIdle()
            val picture = savePicture("path-light")
            for (line in 0..2) picture.count(Palette.LIGHT.line(line)) shouldBeGreaterThan 100
            picture.count(Palette.LIGHT.warning) shouldBeGreaterThan 20
        }
    }

    test("the pointer over the path moves the cursor to the time when the robot was there, and a click pins it") {
        path { viewer ->
            val trail = recording.paths.plotOf(viewer.board.state.graphs[0].lines)!!.driven!!.trail
            val index = trail.indexAt(9.0)
            plot().performMouseInput { moveTo(placeOf(viewer, trail.x[index], trail.y[index], width, height)) }
            viewer.view.cursor.shouldNotBeNull() shouldBe (9.0 plusOrMinus 0.3)
            plot().performMouseInput {
                press()
                release()
            }
            viewer.view.isCursorPinned shouldBe true
        }
    }

    test("the wheel with Ctrl and a drag zoom into the field, which keeps its shape; a double click shows all of it") {
        path { viewer ->
            val id = viewer.board.state.graphs[0].id
            plot().performMultiModalInput {
                key { keyDown(Key.CtrlLeft) }
                mouse {
                    moveTo(center)
                    scroll(-3f, ScrollWheel.Vertical)
                }
                key { keyUp(Key.CtrlLeft) }
            }
            val zoomed = viewer.graphs.planes[id].shouldNotBeNull()
            plot().performMouseInput {
                moveTo(Offset(width * 0.3f, height * 0.3f))
                press()
                moveTo(Offset(width * 0.5f, height * 0.5f))
                release()
            }
            val dragged = viewer.graphs.planes[id].shouldNotBeNull()
            (dragged.x.width < zoomed.x.width) shouldBe true
            dragged.x.width / dragged.y.width shouldBe (zoomed.x.width / zoomed.y.width plusOrMinus 0.01)
            plot().performMouseInput { doubleClick() }
            (id in viewer.graphs.planes) shouldBe false
        }
    }

    test("the visible part of a path is stored with the graph, and restored from it") {
        path { viewer ->
            val id = viewer.board.state.graphs[0].id
            plot().performMouseInput {
                moveTo(Offset(width * 0.3f, height * 0.3f))
                press()
                moveTo(Offset(width * 0.5f, height * 0.5f))
                release()
            }
            waitUntil("kept", 60_000) { viewer.board.state.graphs[0].plane != null }
            viewer.board.state.graphs[0].plane shouldBe viewer.graphs.planes[id]
            viewer.board.change { withPlane(id, Span(2.0, 6.0), Span(3.0, 5.0)) }
            waitUntil("shown", 60_000) { viewer.graphs.planes[id] == Plane(Span(2.0, 6.0), Span(3.0, 5.0)) }
            viewer.board.undo()
            viewer.board.undo()
            waitUntil("all", 60_000) { id !in viewer.graphs.planes }
        }
    }

    test("the picture of the field beside the log is drawn behind its path") {
        val folder = tempdir()
        val image = BufferedImage(200, 100, BufferedImage.TYPE_INT_RGB)
        for (x in 0 until 200) for (y in 0 until 100) image.setRGB(x, y, 0x00FF00)
        ImageIO.write(image, "png", File(folder, "green.png"))
        File(folder, "field.json").writeText(
            """{"field-image":"green.png","field-corners":{"top-left":[0,0],"bottom-right":[200,100]},"field-size":[54,27],"field-unit":"foot"}""",
        )
        val open = OpenRecording.read(Files.copy(recording.file, folder.toPath().resolve("a.bag")))
        runDesktopComposeUiTest(1100, 700) {
            val viewer = viewerOf(open)
            viewer.board.replace(open.standardGraphs)
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            savePicture("path-picture").toPixelMap().buffer.count { Color(it).run { green > 0.9f && red < 0.5f } } shouldBeGreaterThan 50_000
        }
    }
})

/** Returns the content of the first graph. */
private fun pictureOf(viewer: Viewer) = xyPictureOf(viewer.board.state.graphs[0], viewer.compared.drawn)

/** Returns the pixel of a place on the field. The plot has [width] by [height] pixels, and shows the whole field. */
private fun placeOf(viewer: Viewer, x: Double, y: Double, width: Int, height: Int): Offset {
    val plane = pictureOf(viewer).seen(null, width.toDouble(), height.toDouble())!!
    return Offset(plane.xScale(width.toDouble()).placeOf(x).toFloat(), plane.yScale(height.toDouble()).placeOf(y).toFloat())
}
