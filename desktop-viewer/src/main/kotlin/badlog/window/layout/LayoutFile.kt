package badlog.window.layout

import badlog.files.writeAtomically
import badlog.viewer.choices.board.layoutMistake
import badlog.window.task.assertOffWindow
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.NoSuchFileException
import java.nio.file.Path

/**
 * Reads the layout in [file]. Call it off the window's thread.
 *
 * @throws IOException with a sentence for the user, if it is missing, damaged, or not a layout.
 */
internal fun readLayout(file: Path): Layout {
    assertOffWindow()
    val name = file.fileName
    val text = try {
        if (Files.size(file) > MAX_BYTES) throw IOException("$name is too large for a layout; select a file that badlog has saved.")
        Files.readString(file)
    } catch (e: CharacterCodingException) {
        throw IOException("$name is not a layout, since it is not text; select a file that badlog has saved.", e)
    } catch (e: NoSuchFileException) {
        throw IOException("$file does not exist; select another layout.", e)
    }
    val layout = try {
        JSON.decodeFromString<Layout>(text)
    } catch (e: IllegalArgumentException) {
        throw IOException(layoutMistake("$name", text), e)
    }
    if (layout.version > Layout.VERSION) throw IOException("$name was saved by a newer badlog; update badlog to open it.")
    return layout
}

/**
 * Writes [layout] to [file] atomically. Call it off the window's thread.
 *
 * @throws IOException with a sentence for the user, if it cannot be written.
 */
internal fun writeLayout(file: Path, layout: Layout) {
    assertOffWindow()
    val text = JSON.encodeToString(Layout.serializer(), layout)
    writeAtomically(file) { it.write(text.encodeToByteArray()) }
}

private const val MAX_BYTES = 16L shl 20

private val JSON = Json {
    ignoreUnknownKeys = true
    prettyPrint = true
    explicitNulls = false
}

/** Returns [file] in the form for a layout: relative to [folder] if it is in it. Its parts are separated by `/` on every system. */
internal fun pathText(file: Path, folder: Path?): String {
    val base = folder?.toAbsolutePath()?.normalize()
    return if (base != null && file.startsWith(base)) base.relativize(file).joinToString("/") else file.toString()
}

/** Returns the file that a layout contains as [text], relative to [folder]; null if [text] is not a valid path. */
internal fun pathOf(text: String, folder: Path?): Path? = try {
    (folder?.toAbsolutePath()?.resolve(text) ?: Path.of(text)).takeIf { it.isAbsolute }?.normalize()
} catch (_: InvalidPathException) {
    null
}
