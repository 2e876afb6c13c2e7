package badlog.files

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import java.nio.file.Files

class ThisComputerSpec : FunSpec({
    test("a computer keeps its id, which distinguishes it from others of the same name") {
        val ids = List(20) { tempdir().toPath().resolve("settings/badlog") }.map { settings ->
            computerId(settings).also { computerId(settings) shouldBe it }
        }
        ids.toSet().size shouldNotBe 1
        ids.all { Regex("[0-9a-f]{4}").matches(it.orEmpty()) } shouldBe true
    }

    test("without a folder of settings, or with a damaged id, there is no id") {
        val file = Files.writeString(tempdir().toPath().resolve("settings"), "a file")
        computerId(file) shouldBe null
        val folder = tempdir().toPath()
        Files.writeString(folder.resolve("computer-id"), "../x")
        computerId(folder) shouldBe null
    }

    test("a name becomes a part of file names") {
        fileNamePart("Pit Laptop") shouldBe "pit-laptop"
    }
})
