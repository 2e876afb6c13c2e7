package badlog.viewer.choices.board

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

class FolderLayoutSpec : FunSpec({
    fun write(folder: Path, name: String, line: String): Path = Files.writeString(folder.resolve(name), BoardLayout(Board().withGraph(listOf(line)), formulas = listOf("A = 1")).toJson())

    fun lineFor(log: Path, top: Path? = null, type: String? = null) = FolderLayout.of(log, top) { type }.layout?.board?.graphs?.single()?.lines?.single()

    test("the layout is from the log's folder, otherwise from a folder above it up to the top, otherwise missing") {
        val top = tempdir().toPath()
        val day = Files.createDirectories(top.resolve("day 1"))
        val log = day.resolve("a.bag")
        FolderLayout.of(log, top) shouldBe FolderLayout.NONE
        write(top, FolderLayout.NAME, "Above")
        lineFor(log, top) shouldBe "Above"
        lineFor(log).shouldBeNull()
        val own = write(day, FolderLayout.NAME, "Own")
        lineFor(log, top) shouldBe "Own"
        FolderLayout.of(log, top).text shouldBe Files.readString(own)
        FolderLayout.of(log, top).layout.shouldNotBeNull().formulas shouldBe listOf("A = 1")
    }

    test("the kept layouts of a folder have names of their own, and are in their order") {
        val folder = tempdir().toPath()
        for (name in listOf("power", "Drive", "default", "practice", "auto")) write(folder, "$name.badlog-layout.json", "A")
        Files.writeString(folder.resolve("notes.json"), "{}")
        Files.createDirectories(folder.resolve("folder.badlog-layout.json"))
        FolderLayout.keptIn(folder).keys.toList() shouldBe listOf("auto", "Drive", "power")
        FolderLayout.keptIn(folder)["Drive"] shouldBe folder.resolve("Drive.badlog-layout.json")
        FolderLayout.inOrder(mapOf("b" to folder, "B" to folder, "a" to folder)).keys.toList() shouldBe listOf("a", "B", "b")
        FolderLayout.nameOf(folder.resolve("default.badlog-layout.json")) shouldBe null
        val gone = folder.resolve("gone")
        shouldThrow<IOException> { FolderLayout.keptIn(gone) }.message shouldBe
            "The layouts in $gone cannot be read; check that the folder is there and may be read."
    }

    test("a file for the type of the match is first, and the type is read only if there is such a file") {
        val folder = tempdir().toPath()
        val log = folder.resolve("a.bag")
        write(folder, FolderLayout.NAME, "All")
        FolderLayout.of(log) { error("Nobody needs the type.") }.file shouldBe folder.resolve(FolderLayout.NAME)
        write(folder, "practice.badlog-layout.json", "Practice")
        write(folder, "elimination.badlog-layout.json", "Elimination")
        lineFor(log, type = "Practice") shouldBe "Practice"
        lineFor(log, type = "Qualification") shouldBe "All"
        for (type in listOf("Elimination", "Playoff", "SEMIFINAL", "Final")) lineFor(log, type = type) shouldBe "Elimination"
        lineFor(log, type = null) shouldBe "All"
    }

    test("a file with a mistake is reported with its name, the place and the next step, and is not used") {
        val folder = tempdir().toPath()
        val log = folder.resolve("a.bag")
        val file = folder.resolve(FolderLayout.NAME)
        fun problemOf(text: String) = FolderLayout.of(log.also { Files.writeString(file, text) }).also { it.layout.shouldBeNull() }.problem.shouldNotBeNull()
        problemOf("""{"badlog-layout":1,"graphs":[{"title":"A","lines":["A"]},{"lines":[]}]}""") shouldBe
            "The layout $file is not used: The graphs are damaged: graph 2 has no “title” (line 1, column 58); select a file that badlog has saved."
        problemOf("[") shouldContain "is not used: It is not a layout, or is damaged in line 1, column 2"
        problemOf("""{"badlog-layout":99}""") shouldContain "saved by a newer badlog"
        problemOf(" ".repeat(2 shl 20)) shouldContain "larger than 1 MB"
        Files.write(file, byteArrayOf(-1, -2, 0))
        FolderLayout.of(log).problem.shouldNotBeNull() shouldContain "not UTF-8 text"
    }
})
