package badlog.viewer.layout

import badlog.analysis.Span
import badlog.viewer.app.Viewer
import badlog.viewer.board.GraphList
import badlog.viewer.board.GraphSpec
import badlog.viewer.board.LineSpec
import badlog.viewer.compare.Comparison
import badlog.viewer.export.armBag
import badlog.viewer.export.recordingOf
import badlog.viewer.graph.standardGraphs
import badlog.viewer.library.LibraryState
import badlog.viewer.panels.InspectorTab
import badlog.viewer.panels.MainView
import badlog.viewer.panels.Panels
import badlog.viewer.settings.UserFolders
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.coroutines.MainScope
import java.io.IOException
import java.nio.file.Files

class LayoutSpec : FunSpec({
    val home = tempdir().toPath()
    val folder = Files.createDirectories(home.resolve("logs"))
    val arm = recordingOf(armBag(500), folder.resolve("match.bag"))
    val chosen = GraphSpec(7, "Mine", listOf(LineSpec("Arm/Angle"), LineSpec("Arm/Current")), isFilled = true, yRange = Span(-1.0, 1.0))

    fun viewerOver(graphs: GraphList? = null) = Viewer(MainScope(), UserFolders(home, home)).apply {
        library.change { LibraryState(folder) }
        current.replace(arm)
        view.show(arm.span)
        board.replace(graphs ?: standardGraphs(arm.view))
    }

    test("a window saved and opened again is the same window") {
        val other = Files.writeString(folder.resolve("other.bag"), "")
        val arranged = viewerOver(GraphList(listOf(chosen)))
        arranged.view.change { showing(1.0, 2.0) }
        arranged.view.select(Span(1.2, 1.4))
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

    test("files below the folder are named from there, so that a layout moves with its folder") {
        pathText(folder.resolve("day 1/a.bag"), folder) shouldBe "day 1/a.bag"
        pathOf("day 1/a.bag", folder) shouldBe folder.resolve("day 1").resolve("a.bag")
        val outside = home.resolve("elsewhere.bag")
        pathOf(pathText(outside, folder), folder) shouldBe outside
    }

    test("lines of which the recording has no signal are left out, and graphs without any line, and both are said") {
        val viewer = viewerOver()
        val graphs = listOf(
            LayoutGraph("Both", listOf("Arm/Angle", "Wrist/Angle")),
            LayoutGraph("Gone", listOf("Wrist/Angle", "Claw")),
            LayoutGraph("Without lines", emptyList()),
        )
        viewer.layouts.apply(Layout(Layout.VERSION, graphs))
        viewer.board.state.graphs.map { graph -> graph.title to graph.lines.map { it.signal } } shouldBe listOf("Both" to listOf("Arm/Angle"))
        val said = viewer.notices.all.single()
        said.isError shouldBe false
        said.text shouldContain "“Wrist/Angle”, “Claw”"
    }

    test("standard graphs are kept as such, and bring back what the attributes ask for") {
        viewerOver().layouts.layout.graphs shouldBe null
        val viewer = viewerOver(GraphList(listOf(chosen)))
        viewer.layouts.showDefaultGraphs()
        viewer.board.state shouldBe standardGraphs(arm.view)
    }

    test("ranges that are none, or lie outside the recording, show all of it") {
        val viewer = viewerOver()
        viewer.layouts.apply(Layout(Layout.VERSION, visible = LayoutSpan(900.0, 901.0), selection = LayoutSpan(2.0, 1.0)))
        viewer.view.viewport.visible shouldBe arm.span
        viewer.view.selection shouldBe null
    }

    test("unknown keys and unknown panels of a newer program are passed over") {
        val file = Files.writeString(
            home.resolve("newer.json"),
            """{"badlog-layout":1,"colour":"red","graphs":[{"title":"A","lines":["Arm/Angle"],"log":true}],"panels":{"main":"MAP"}}""",
        )
        val viewer = viewerOver()
        viewer.layouts.apply(readLayout(file))
        viewer.board.state.graphs.single().title shouldBe "A"
        viewer.panels.state.main shouldBe MainView.GRAPHS
    }

    test("a damaged, a foreign, a newer and a missing file are each told in a sentence that names it") {
        val contents = mapOf(
            "cut.json" to """{"badlog-layout":1,"graphs":[{"ti""",
            "foreign.json" to """{"name":"package","version":"1.0.0"}""",
            "empty.json" to "",
            "wrong.json" to """{"badlog-layout":1,"graphs":"all"}""",
            "newer.json" to """{"badlog-layout":2}""",
        )
        for ((name, content) in contents) {
            Files.writeString(home.resolve(name), content)
            shouldThrow<IOException> { readLayout(home.resolve(name)) }.message shouldContain name
        }
        Files.write(home.resolve("binary.json"), byteArrayOf(-1, -2, 0, 7))
        shouldThrow<IOException> { readLayout(home.resolve("binary.json")) }.message shouldContain "binary.json"
        shouldThrow<IOException> { readLayout(home.resolve("missing.json")) }.message shouldContain "not there"
    }
})
