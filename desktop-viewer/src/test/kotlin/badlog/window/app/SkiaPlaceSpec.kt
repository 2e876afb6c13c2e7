package badlog.window.app

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import org.jetbrains.skia.Surface
import java.io.File
import java.nio.file.Files

@Tags("InCheck")
class SkiaPlaceSpec : FunSpec({
    test("the program draws without a home folder, and leaves no files behind") {
        val folder = tempdir().toPath()
        val home = Files.createFile(folder.resolve("home"))
        val temporary = Files.createDirectory(folder.resolve("temporary"))
        val java = File(System.getProperty("java.home"), "bin/java").path
        val options = listOf("-Djava.awt.headless=true", "-Duser.home=$home", "-Djava.io.tmpdir=$temporary")
        val program = ProcessBuilder(listOf(java) + options + listOf("-cp", System.getProperty("java.class.path"), "badlog.window.app.SkiaPlaceSpecKt"))
        val output = program.redirectErrorStream(true).start().inputStream.reader().use { it.readText() }
        output.trim() shouldBe "drawn"
        // Windows does not delete loaded libraries.
        if (System.getProperty("os.name").startsWith("Windows")) return@test
        Files.list(temporary).use { files -> files.filter { it.fileName.toString().startsWith("badlog") }.count() } shouldBe 0
    }
})

/** Draws after the same preparation as the window. */
fun main() {
    placeSkia()
    Surface.makeRasterN32Premul(1, 1).close()
    println("drawn")
}
