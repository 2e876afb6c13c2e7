package badlog.fetch

import badlog.file.LogName

/**
 * [name], which came from a robot or a log and may hold anything, as the name of a file or folder on any system: without folders, signs
 * that a system refuses, and what nobody would see; not hidden, and not too long.
 */
internal fun safeName(name: String): String {
    val signs = buildString {
        name.codePoints().forEach { if (isUnsafe(it)) append('_') else appendCodePoint(it) }
    }
    // Windows drops what a name may not end in.
    val bare = signs.trimEnd('.', ' ').trimStart(' ').let { if (it.startsWith(".")) "_" + it.drop(1) else it }.ifEmpty { "_" }
    val short = shortened(bare).trimEnd('.', ' ')
    return if (short.substringBefore('.').trim().uppercase() in DEVICES) "_$short" else short
}

/** [name] with its beginning and its ending, where it is too long. */
private fun shortened(name: String): String {
    if (name.encodeToByteArray().size <= MAX_BYTES) return name
    val ending = name.drop(LogName.of(name).stem.length).takeIf { it.length <= MAX_ENDING }.orEmpty()
    var stem = name.dropLast(ending.length)
    while (stem.encodeToByteArray().size + ending.length > MAX_BYTES) stem = stem.dropLast(if (stem.last().isLowSurrogate()) 2 else 1)
    return stem + ending
}

private fun isUnsafe(sign: Int) = Character.isISOControl(sign) || (sign < ASCII_END && sign.toChar() in REFUSED) ||
    Character.getType(sign).toByte() in UNSEEN

private const val REFUSED = "/\\:*?\"<>|"
private const val ASCII_END = 0x80
private val UNSEEN = setOf(Character.FORMAT, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR, Character.SURROGATE)

/** What Windows takes for devices, whatever the ending. */
private val DEVICES = setOf("CON", "PRN", "AUX", "NUL") + (0..9).flatMap { listOf("COM$it", "LPT$it") }

/** Systems take 255; a number may come behind it. */
private const val MAX_BYTES = 180
private const val MAX_ENDING = 20
