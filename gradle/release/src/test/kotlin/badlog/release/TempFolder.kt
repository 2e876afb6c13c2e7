package badlog.release

import io.kotest.core.spec.style.FunSpec
import java.io.File
import kotlin.io.path.createTempDirectory

/** A folder that is removed when the spec has ended. */
internal fun FunSpec.tempFolder(): File {
    val folder = createTempDirectory("badlog-release").toRealPath().toFile()
    afterSpec { folder.deleteRecursively() }
    return folder
}
