package badlog.site

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.readText

/** The types that the API's pages describe. */
internal object ApiTypes {
    /** A type: its short [name], its [full] name with its package, and its page, relative to the API's folder. */
    data class Type(val name: String, val full: String, val address: String)

    /** Reads the list that Dokka left in [folder]. Types have their kind in front of their name, as in “class BagParser”; enum entries do not. */
    fun read(folder: Path): List<Type> = Json.parseToJsonElement((folder / "scripts" / "pages.json").readText()).jsonArray
        .map { entry -> entry.jsonObject.mapValues { (_, value) -> (value as? JsonPrimitive)?.content.orEmpty() } }
        .filter { ' ' in it.getValue("name") && it.getValue("location").endsWith("/index.html") }
        .map { Type(it.getValue("description").substringAfterLast('.'), it.getValue("description"), it.getValue("location")) }
}
