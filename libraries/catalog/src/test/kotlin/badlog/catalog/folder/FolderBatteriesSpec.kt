package badlog.catalog.folder

import badlog.rules.BatteriesFile
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.readText
import kotlin.io.path.writeText

class FolderBatteriesSpec : FunSpec({
    test("logs of one name in two folders have batteries of their own, in the file above them") {
        val top = tempdir().toPath()
        val file = top.resolve(BatteriesFile.NAME).also { it.writeText("") }
        val (one, other) = listOf("a", "b").map { top.resolve(it).createDirectories().resolve("q1.bag") }
        FolderBatteries.assign("A1", listOf(one), "Qualification 1", top).shouldBeNull()
        file.readText() shouldBe "[used]\n\"a/q1.bag\" = \"A1\"\n"
        val read = FolderBatteries.of(listOf(one, other), top)
        read.usedFor(listOf(one), "Qualification 1") shouldBe "A1"
        read.usedFor(listOf(other), "Qualification 1").shouldBeNull()
        FolderBatteries.assign("", listOf(one), "Qualification 1", top).shouldBeNull()
        FolderBatteries.of(listOf(one), top).usedFor(listOf(one), null).shouldBeNull()
    }

    test("removing a match's record works, and without a record nothing is written") {
        val folder = tempdir().toPath()
        val log = folder.resolve("q1.bag")
        FolderBatteries.assign("", listOf(log), "Qualification 1", folder).shouldBeNull()
        Files.exists(folder.resolve(BatteriesFile.NAME)) shouldBe false
        folder.resolve(BatteriesFile.NAME).writeText("[used]\n\"Qualification 1\" = \"A1\"\n")
        FolderBatteries.assign("", listOf(log), "Qualification 1", folder).shouldBeNull()
        FolderBatteries.of(listOf(log), folder).usedFor(listOf(log), "Qualification 1").shouldBeNull()
    }

    test("a file with a mistake is neither used nor changed") {
        val folder = tempdir().toPath()
        val file = folder.resolve(BatteriesFile.NAME).also { it.writeText("used = 1\n") }
        val log = folder.resolve("q1.bag")
        FolderBatteries.of(listOf(log), folder).problems.single() shouldContain "$file is not used: "
        FolderBatteries.assign("A1", listOf(log), null, folder)!! shouldContain "$file is not changed: "
        file.readText() shouldBe "used = 1\n"
    }

    test("a log that is named without its folder is in the current one") {
        val log = Path.of("no-such-log.bag")
        FolderBatteries.of(listOf(log), null).usedFor(listOf(log), null).shouldBeNull()
        FolderBatteries.of(listOf(log), null).problems.shouldBeEmpty()
    }
})
