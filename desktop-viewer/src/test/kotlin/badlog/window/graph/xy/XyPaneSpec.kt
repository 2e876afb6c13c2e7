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
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performMultiModalInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.path.Field
import badlog.viewer.draw.path.xScale
import badlog.viewer.draw.path.yScale
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.change
import badlog.window.graph.TestGraphs
import badlog.window.graph.graphActions
import badlog.window.graph.sample
import badlog.window.graph.savePicture
import badlog.window.graph.viewerOf
import badlog.window.graph.waitForPictures
import badlog.window.log.OpenRecording
import badlog.window.theme.Palette
import badlog.window.theme.Theme
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
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
    fun path(theme: Theme = Theme.LIGHT, test: DesktopComposeUiTest.(Viewer) -> Unit) = runDesktopComposeUiTest(1100, 700) {
        val viewer = viewerOf(recording)
        viewer.board.replace(recording.standardGraphs)
        setContent { TestGraphs(viewer, theme) }
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
        path(Theme.DARK) { viewer ->
            viewer.view.send(PlaceAction.MoveCursor(9.4))
            waitForIdle()
            savePicture("path-dark").count(Palette.DARK.line(0)) shouldBeGreaterThan 100
        }
    }

    test("the second cursor is a ring on the path, at the robot's place then") {
        path { viewer ->
            viewer.view.send(PlaceAction.GoTo(9.4))
            waitForIdle()
            val one = savePicture("path-second").count(Palette.LIGHT.line(0))
            viewer.view.send(PlaceAction.Click(3.0, reach = 0.0, isShifted = true))
            waitForIdle()
            savePicture("path-second").count(Palette.LIGHT.line(0)) shouldBeGreaterThan one + 20
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

    test("Escape cancels a drag over a path: a frame is not shown, a move is taken back") {
        path { viewer ->
            val menus = viewer.keyboard.menus
            val id = viewer.board.state.graphs[0].id
            for (key in listOf(null, Key.ShiftLeft)) {
                plot().performMultiModalInput {
                    if (key != null) key { keyDown(key) }
                    mouse {
                        moveTo(Offset(width * 0.3f, height * 0.3f))
                        press()
                        moveTo(Offset(width * 0.5f, height * 0.6f))
                    }
                }
                waitForIdle()
                (id in viewer.graphs.planes) shouldBe (key != null)
                menus.closeLast() shouldBe true
                plot().performMultiModalInput {
                    mouse { release() }
                    if (key != null) key { keyUp(key) }
                }
                waitForIdle()
                (id in viewer.graphs.planes) shouldBe false
                menus.closeLast() shouldBe false
            }
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

    test("the red origin moves the path to the other half of the field") {
        path { viewer ->
            val graph = viewer.board.state.graphs[0]
            fun startX() = pictureOf(viewer).parts[0].plot.driven!!.trail.x[0]
            val blue = startX()
            val menu = graphActions(viewer.graphs, graph).flatten().filter { "origin" in it.label }
            menu.map { it.label to it.isOn } shouldBe listOf("Blue origin" to true, "Red origin" to false, "Auto origin" to false, "Center origin" to false)
            menu[1].run()
            waitForPictures(viewer)
            savePicture("path-red-origin")
            startX() shouldBe (Field.LENGTH - blue plusOrMinus 1e-9)
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

    test("a click on its legend hides a trace") {
        path { viewer ->
            viewer.board.change { Board(graphs.take(1)) }
            waitForPictures(viewer)
            val before = savePicture("path-hidden").count(Palette.LIGHT.line(1))
            onNodeWithContentDescription("Hide Target Pose").performClick()
            waitForIdle()
            savePicture("path-hidden").count(Palette.LIGHT.line(1)) shouldBeLessThan before / 2
            viewer.board.state.graphs[0].hidden shouldBe setOf("Drive/Target Pose X", "Drive/Target Pose Y")
        }
    }

    test("volts over amperes are drawn as dots, with the battery's resistance") {
        val match = sample("qualification-42.bag")
        runDesktopComposeUiTest(1100, 500) {
            val viewer = viewerOf(match)
            viewer.board.replace(Board().withGraph(listOf("PDP/Total Current", "System/Battery Voltage")).withXy(1, true))
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            savePicture("resistance").count(Palette.LIGHT.line(0)) shouldBeGreaterThan 1000
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
