package badlog.cli.export

import java.io.ByteArrayInputStream
import java.nio.file.Path
import java.util.Base64
import java.util.zip.GZIPInputStream
import kotlin.io.path.readText

/** What [page] carries besides the log, as JSON; empty for nothing. */
internal fun additionsOf(page: Path): String {
    val packed = page.readText().substringAfter("id=\"packed-additions\">", "").substringBefore('<')
    if (packed.isEmpty()) return ""
    return GZIPInputStream(ByteArrayInputStream(Base64.getDecoder().decode(packed))).readAllBytes().decodeToString()
}
