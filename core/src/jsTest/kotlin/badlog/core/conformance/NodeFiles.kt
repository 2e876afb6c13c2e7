@file:JsModule("fs")

package badlog.core.conformance

import org.khronos.webgl.Uint8Array

// Node's own functions.

internal external fun readdirSync(folder: String): Array<String>

internal external fun readFileSync(path: String): Uint8Array
