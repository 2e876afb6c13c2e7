package badlog.window.layout

import badlog.core.analysis.Span
import badlog.files.UserFolders
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.compare.Comparison
import badlog.window.export.armBag
import badlog.window.export.recordingOf
import badlog.window.folder.LibraryState
import badlog.window.graph.choosing
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView
import badlog.window.sidebar.Panels
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import java.nio.file.Files

class LayoutSpec : FunSpec({
    val home = tempdir().toPath()
    val folder = Files.createDirectories(home.resolve("logs"))
    val arm = recordingOf(armBag(500), folder.resolve("match.bag"))
    val chosen = BoardGraph(7, "Mine", listOf("Arm/Angle", "Arm/Current"), isFilled = true, yRange = Span(-1.0, 1.0))

    fun viewerOver(graphs: Board? = null) = Viewer(MainScope(), UserFolders(home, home)).apply {
        library.change { LibraryState(folder) }
        current.replace(arm)
        view.send(PlaceAction.Open(arm.span))
        board.replace(graphs ?: defaultBoard(arm.view))
    }

    test("a window that is saved and opened again is the same") {
        val other = Files.writeString(folder.resolve("other.bag"), "")
        val arranged = viewerOver(Board(listOf(chosen)))
        arranged.view.send(PlaceAction.Show(1.0, 2.0))
        arranged.view.send(PlaceAction.Select(Span(1.2, 1.4)))
        arranged.compared.change { Comparison(checked = listOf(other)) }
        arranged.panels.change { Panels(topics = false, inspector = InspectorTab.EVENTS, main = MainView.STATISTICS) }
        val file = home.resolve("a${Layout.ENDING}")
        writeLayout(file, arranged.layouts.layout)

        val fresh = viewerOver()
        fresh.layouts.apply(readLayout(file))
        fresh.board.state.graphs.map { it.copy(id = 7) } shouldBe listOf(chosen)
        fresh.view.viewport.visible shouldBe Span(1.0, 2.0)
        fresh.view.selection shouldBe Span(1.2, 1.4)
        fresh.compared.state.checked shouldBe listOf(other)
        fresh.panels.state shouldBe arranged.panels.state
        fresh.notices.all.shouldBeEmpty()
        fresh.layouts.layout shouldBe arranged.layouts.layout
    }

    test("a layout file of version 1 can be opened, and is written in the same form") {
        val file = home.resolve("today.json")
        Files.writeString(file, LAYOUT_1)
        val viewer = viewerOver()
        val layout = readLayout(file)
        choosing(viewer) { viewer.layouts.apply(layout) }
        viewer.board.state.renumbered().graphs shouldBe listOf(
            BoardGraph(1, "Arm/Angle", listOf("Arm/Angle", "Arm/Current"), isFilled = true, yRange = Span(-1.0, 12.5)),
            BoardGraph(2, "Mode", listOf("Arm/Mode"), includesZero = true),
        )
        viewer.view.viewport.visible shouldBe Span(1.0, 2.0)
        viewer.panels.state.inspector shouldBe InspectorTab.EVENTS
        writeLayout(file, readLayout(file))
        Files.readString(file) shouldBe LAYOUT_1
    }

    test("files below the folder are named relative to it, so that a layout moves with its folder") {
        pathText(folder.resolve("day 1/a.bag"), folder) shouldBe "day 1/a.bag"
        pathOf("day 1/a.bag", folder) shouldBe folder.resolve("day 1").resolve("a.bag")
        val outside = home.resolve("elsewhere.bag")
        pathOf(pathText(outside, folder), folder) shouldBe outside
    }

    test("invalid ranges, and ranges outside the recording, show all of it") {
        val viewer = viewerOver()
        viewer.layouts.apply(Layout(Layout.VERSION, visible = LayoutSpan(900.0, 901.0), selection = LayoutSpan(2.0, 1.0)))
        viewer.view.viewport.visible shouldBe arm.span
        viewer.view.selection shouldBe null
    }

    test("unknown keys and unknown panels of a newer program are ignored") {
        val file = Files.writeString(
            home.resolve("newer.json"),
            """{"badlog-layout":1,"color":"red","graphs":[{"title":"A","lines":["Arm/Angle"],"log":true}],"panels":{"main":"MAP"}}""",
        )
        val viewer = viewerOver()
        viewer.layouts.apply(readLayout(file))
        viewer.board.state.graphs.single().title shouldBe "A"
        viewer.panels.state.main shouldBe MainView.GRAPHS
    }
})

/** The form in which badlog wrote layouts before boards had a form of their own. */
private val LAYOUT_1 = """
{
    "badlog-layout": 1,
    "graphs": [
        {
            "title": "Arm/Angle",
            "lines": [
                "Arm/Angle",
                "Arm/Current"
            ],
            "filled": true,
            "y": {
                "from": -1.0,
                "to": 12.5
            }
        },
        {
            "title": "Mode",
            "lines": [
                "Arm/Mode"
            ],
            "zero": true
        }
    ],
    "recording": "match.bag",
    "visible": {
        "from": 1.0,
        "to": 2.0
    },
    "panels": {
        "topics": false,
        "inspector": "EVENTS",
        "main": "GRAPHS"
    },
    "formulas": [
        "Twice = Arm/Angle * 2"
    ]
}
""".trim()
