package badlog.season.engine

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.nio.file.Files

class ScratchFolderSpec : FunSpec({
    test("at the end of the program the folder is there until the work is finished, also if that fails; then no work begins") {
        val said = ArrayList<String>()
        ScratchFolder().use { scratch ->
            val end = { what: String ->
                said += "$what ${Files.exists(scratch.path)}"
                error("the disk is full")
            }
            scratch.finishing({ end("earlier") }) {}
            scratch.finishing({ end("now") }) { shouldThrow<IllegalStateException> { scratch.end() } }
            said shouldBe listOf("now true")
            Files.exists(scratch.path) shouldBe false
            shouldThrow<InterruptedException> { scratch.finishing({}) { said += "begun" } }
            said shouldBe listOf("now true")
        }
    }

    test("the folder goes when it is closed, with what is in it") {
        val scratch = ScratchFolder()
        Files.createFile(scratch.path.resolve("a.tmp"))
        scratch.close()
        Files.exists(scratch.path) shouldBe false
    }
})
