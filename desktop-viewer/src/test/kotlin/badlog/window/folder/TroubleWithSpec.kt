package badlog.window.folder

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.string.shouldContain
import java.io.IOException
import java.nio.file.AccessDeniedException
import java.nio.file.NoSuchFileException
import java.nio.file.Path

class TroubleWithSpec : FunSpec({
    val folder = Path.of("/logs")

    test("missing permission for a folder is not reported as a missing drive") {
        troubleWith(folder, AccessDeniedException("/logs")) shouldContain "permission denied"
        troubleWith(folder, NoSuchFileException("/logs")) shouldContain "There is no folder /logs"
        troubleWith(folder, IOException("x")) shouldContain "is its drive connected?"
    }
})
