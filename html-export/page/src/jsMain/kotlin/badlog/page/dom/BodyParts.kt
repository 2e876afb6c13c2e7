package badlog.page.dom

import org.khronos.webgl.Uint8Array
import org.w3c.fetch.Response
import kotlin.js.Promise

/** Promises the bytes of [response] in parts. Each part is passed to [onPart] as it arrives. Rejected if the rest does not arrive. */
internal fun partsOf(response: Response, onPart: (Uint8Array) -> Unit): Promise<List<Uint8Array>> {
    val reader = response.asDynamic().body.getReader().unsafeCast<StreamReader>()
    val parts = ArrayList<Uint8Array>()
    fun next(): Promise<List<Uint8Array>> = reader.read().then { part ->
        val bytes = part.value ?: return@then Promise.resolve(parts)
        parts += bytes
        onPart(bytes)
        next()
    }.unsafeCast<Promise<List<Uint8Array>>>()
    return next()
}

/** The browser's reader of a body that arrives in parts. */
private external interface StreamReader {
    fun read(): Promise<StreamPart>
}

/** A part of a body; without a value at its end. */
private external interface StreamPart {
    val value: Uint8Array?
}
