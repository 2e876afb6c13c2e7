package badlog.core.conformance

import org.khronos.webgl.Int8Array

// Set by the build, because Node runs the tests in a different folder.
private val folder = js("process.env.BADLOG_CONFORMANCE").unsafeCast<String>()

internal actual fun corpusFileNames(): List<String> = readdirSync(folder).sorted()

internal actual fun readCorpusFile(name: String): ByteArray {
    val bytes = readFileSync("$folder/$name")
    return Int8Array(bytes.buffer, bytes.byteOffset, bytes.length).unsafeCast<ByteArray>().copyOf()
}
