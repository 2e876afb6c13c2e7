package badlog.files

/**
 * Returns [name] as a name for a file or folder on any system. [name] may come from a robot or a log and contain anything. The result has
 * no folders, and no forbidden or invisible characters. It is neither hidden nor too long.
 */
public fun safeName(name: String): String {
    val signs = buildString {
        name.codePoints().forEach { if (isUnsafe(it)) append('_') else appendCodePoint(it) }
    }
    // Windows drops characters that a name may not end in.
    val bare = signs.trimEnd('.', ' ').trimStart(' ').let { if (it.startsWith(".")) "_" + it.drop(1) else it }.ifEmpty { "_" }
    val short = shortened(bare).trimEnd('.', ' ')
    return if (short.substringBefore('.').trim().uppercase() in DEVICES) "_$short" else short
}

/** Returns [name] shortened in the middle if it is too long. */
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

/** Names of devices on Windows, whatever the ending. */
private val DEVICES = setOf("CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$") +
    ("0123456789¹²³").flatMap { listOf("COM$it", "LPT$it") }

/** Systems allow 255; a number may be appended. */
private const val MAX_BYTES = 180
private const val MAX_ENDING = 20
