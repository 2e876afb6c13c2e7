package badlog.files

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.File
import java.nio.file.Files
import kotlin.io.path.createDirectory
import kotlin.io.path.div
import kotlin.io.path.writeText

class ProgramOnPathSpec : FunSpec({
    test("a program is found in the first folder of the PATH that has it, and a file that cannot be run is not one") {
        val folder = Files.createTempDirectory("badlog")
        try {
            val folders = listOf("a", "b", "c").map { (folder / it).createDirectory() }
            (folders[0] / "owlet").writeText("")
            for (place in folders.drop(1)) (place / "owlet").apply { writeText("") }.toFile().setExecutable(true)
            val path = listOf("", "nowhere\u0000") + folders.map { it.toString() }
            programOnPath("owlet", path.joinToString(File.pathSeparator)) shouldBe folders[1] / "owlet"
            programOnPath("owl", path.joinToString(File.pathSeparator)) shouldBe null
            programOnPath("owlet", null) shouldBe null
        } finally {
            folder.toFile().deleteRecursively()
        }
    }
})
