package badlog.season.engine

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.nio.file.Files

class ScratchFolderSpec : FunSpec({
    test("at the end of the program the folder exists until the work has finished or failed, and no new work begins") {
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

    test("closing the folder deletes it with its content") {
        val scratch = ScratchFolder()
        Files.createFile(scratch.path.resolve("a.tmp"))
        scratch.close()
        Files.exists(scratch.path) shouldBe false
    }
})
