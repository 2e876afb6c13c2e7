package badlog.window.export

import badlog.exporter.additionsIn
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.boardLayoutOf
import badlog.window.findings.ruleText
import badlog.window.findings.writeRules
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.nio.file.Files

class PageExportSpec : FunSpec({
    test("a broken log among many is reported, and the pages of the others are made") {
        val folder = tempdir().toPath()
        val logs = listOf("a.bag", "broken.bag", "b.bag").map(folder::resolve)
        for (log in logs) Files.writeString(log, armBag(20))
        Files.write(logs[1], byteArrayOf(0x50, 0x4b, 3, 4, 0, 0, 0, 0))
        val shares = ArrayList<Float>()
        val pages = makePages(pageJobs(logs, folder.resolve("pages")), Additions(emptyList(), emptyList(), folder)) { shares += it }
        pages.made.map { it.fileName.toString() } shouldContainExactly listOf("a.bag.html", "b.bag.html")
        Files.readString(pages.made[0]).lowercase() shouldStartWith "<!doctype html>"
        pages.failures shouldHaveSize 1
        pages.failures.single() shouldContain "broken.bag"
        shares shouldBe shares.sorted()
        shares.last() shouldBe 1f
    }

    test("pages contain the formulas that work there, and the rules of the folder") {
        val folder = tempdir().toPath()
        val log = Files.writeString(folder.resolve("a.bag"), armBag(100))
        writeRules(folder, ruleText("Far", "Arm/Angle > 40", "error", "The arm went to {value}."))
        val formulas = listOf("Twice = 2 * Arm/Angle", "Gone = Wrist/Angle / 2")
        val additions = Additions(emptyList(), formulas, folder).of(log)
        additions.virtualTopics shouldContainExactly listOf("Twice = 2 * Arm/Angle")
        additions.rules.rules.map { it.name } shouldContainExactly listOf("Far")
        val page = makePages(pageJobs(listOf(log), folder), Additions(emptyList(), formulas, folder)).made.single()
        additionsIn(page) shouldContain "The arm went to {value}."
        Additions(emptyList(), formulas, folder).of(folder.resolve("gone.bag")).virtualTopics shouldBe emptyList()
    }

    test("pages begin with the graphs of the window, if there are any") {
        val folder = tempdir().toPath()
        val log = Files.writeString(folder.resolve("a.bag"), armBag(100))
        val board = Board(listOf(BoardGraph(1, "Arm/Angle", listOf("Arm/Angle", "Arm/Current"))))
        val given = boardLayoutOf("board", checkNotNull(Additions(emptyList(), emptyList(), folder, board).of(log).layout))
        given.board?.graphs?.map { it.lines } shouldBe listOf(listOf("Arm/Angle", "Arm/Current"))
        Additions(emptyList(), emptyList(), folder).of(log).layout shouldBe null
    }

    test("the page of a compared log contains the other log, too") {
        val folder = tempdir().toPath()
        val (log, other) = listOf("a.bag", "b.bag").map { Files.writeString(folder.resolve(it), armBag(100)) }
        val jobs = listOf(PageJob(log, folder.resolve("a.html"), listOf(other)), PageJob(other, folder.resolve("b.html")))
        val pages = makePages(jobs, Additions(emptyList(), emptyList(), folder)).made.map(Files::readString)
        pages.map { "class=\"compared\" data-name=\"b.bag\"" in it } shouldBe listOf(true, false)
    }

    test("logs of the same name in different folders get pages with different names") {
        val folder = tempdir().toPath()
        val jobs = pageJobs(listOf("one/match.bag", "two/match.bag", "two/MATCH.bag").map(folder::resolve), folder)
        jobs.map { it.page.fileName.toString() } shouldBe listOf("match.bag.html", "match.bag (2).html", "MATCH.bag (3).html")
    }

    test("the logs of a folder include the logs of its subfolders, and no other files") {
        val folder = tempdir().toPath()
        Files.createDirectories(folder.resolve("day 2"))
        for (name in listOf("b.bag", "day 2/a.bag.gz", "notes.txt", "a.CSV", "b.bag.html")) Files.writeString(folder.resolve(name), "")
        logsIn(folder).map { folder.relativize(it).joinToString("/") }.toSet() shouldBe setOf("b.bag", "day 2/a.bag.gz", "a.CSV")
    }
})
