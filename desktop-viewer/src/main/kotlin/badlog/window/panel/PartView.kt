package badlog.window.panel

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.selection.SelectionContainer
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.vector.ImageVector
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.panel.Button
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Card
import badlog.viewer.panel.Cards
import badlog.viewer.panel.Choice
import badlog.viewer.panel.Code
import badlog.viewer.panel.Field
import badlog.viewer.panel.Fold
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Offers
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.Picture
import badlog.viewer.panel.Rows
import badlog.viewer.panel.Table
import badlog.viewer.panel.Tone
import badlog.viewer.panel.Trouble
import badlog.viewer.panel.Value
import badlog.viewer.state.Action
import badlog.window.findings.findingColor
import badlog.window.findings.findingSoft
import badlog.window.pen.pen
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Tip
import badlog.window.theme.ToolButton
import badlog.viewer.panel.Row as PanelRow

/** Shows [part]. A fold shows only its title, because its content consists of further parts. */
@Composable
internal fun PartView(part: Part, send: (Action) -> Unit, modifier: Modifier = Modifier) {
    when (part) {
        is Heading -> HeadingView(part, send)
        is Paragraph -> ParagraphView(part, send)
        is Trouble -> TroubleView(part)
        is Buttons -> FlowRow(Modifier.padding(horizontal = 12.dp), Arrangement.spacedBy(2.dp)) { ButtonsView(part.buttons, send) }
        is Offers -> OffersView(part, send)
        is Choice -> ChoiceView(part, send, modifier)
        is Code -> CodeView(part)
        is Field -> FieldView(part, send)
        is Fold -> FoldTitle(part, send)
        is Rows -> for (row in part.rows) PartView(row, send)
        is PanelRow -> RowView(part, send)
        is Value -> ValueView(part, send)
        is Cards -> CardsView(part, send)
        is Card -> CardView(part, send, modifier)
        is Table -> TableView(part, send)
        is Picture -> PictureView(part)
    }
}

@Composable
private fun HeadingView(heading: Heading, send: (Action) -> Unit) {
    Row(Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp, top = 4.dp), verticalAlignment = Alignment.CenterVertically) {
        // The tab above has the title.
        Text(heading.status, Modifier.weight(1f), fontWeight = FontWeight.Medium)
        ButtonsView(heading.tools, send, areIcons = true)
    }
}

@Composable
private fun ParagraphView(paragraph: Paragraph, send: (Action) -> Unit) {
    Row(Modifier.fillMaxWidth().padding(horizontal = 12.dp, vertical = 2.dp), verticalAlignment = Alignment.CenterVertically) {
        ToneText(paragraph, Modifier.weight(1f))
        paragraph.button?.let { ButtonsView(listOf(it), send) }
    }
}

/** The text of [paragraph], without its button, in the color of its tone. */
@Composable
internal fun ToneText(paragraph: Paragraph, modifier: Modifier = Modifier) {
    val palette = LocalPalette.current
    val color = when (paragraph.tone) {
        Tone.BODY, Tone.TITLE -> palette.text
        Tone.MUTED -> palette.muted
        Tone.ALERT -> palette.error
    }
    val isLarge = paragraph.tone == Tone.TITLE
    Text(paragraph.text, modifier, color, fontSize = if (isLarge) 20.sp else 12.sp, fontWeight = FontWeight.SemiBold.takeIf { isLarge })
}

/** Shows [buttons]; with [areIcons], it shows only their icons. */
@Composable
internal fun ButtonsView(buttons: List<Button>, send: (Action) -> Unit, areIcons: Boolean = false) {
    for (button in buttons) {
        val text = button.label.takeIf { !areIcons }
        ToolButton(button.hint, button.icon?.vector, text, button.isOn, button.isEnabled) { send(button.action) }
    }
}

/** The icon in the window. */
internal val PartIcon.vector: ImageVector
    get() = when (this) {
        PartIcon.PREVIOUS -> Icons.Up
        PartIcon.NEXT -> Icons.Down
        PartIcon.AGAIN -> Icons.Reset
        PartIcon.PIN -> Icons.Pin
        PartIcon.ADD -> Icons.Add
        PartIcon.REMOVE -> Icons.Remove
        PartIcon.NOTE -> Icons.Note
        PartIcon.ZOOM -> Icons.Search
        PartIcon.CLOSE -> Icons.Close
        PartIcon.COPY -> Icons.Copy
        PartIcon.DONE -> Icons.Check
        PartIcon.PERSON -> Icons.Flag
        PartIcon.UNDONE -> Icons.Undo
        PartIcon.HISTOGRAM -> Icons.Chart
    }

@Composable
private fun OffersView(offers: Offers, send: (Action) -> Unit) {
    Column(
        Modifier
            .fillMaxWidth()
            .padding(horizontal = 8.dp, vertical = 4.dp)
            .background(LocalPalette.current.accentSoft, RoundedCornerShape(4.dp))
            .padding(horizontal = 6.dp, vertical = 4.dp)
            .semantics { contentDescription = offers.title },
    ) {
        Text(offers.title, fontWeight = FontWeight.Medium)
        for (button in offers.buttons) {
            Tip(button.hint) {
                Text(button.label, Modifier.fillMaxWidth().clickable(role = Role.Button) { send(button.action) }.padding(vertical = 2.dp))
            }
        }
    }
}

@Composable
private fun FoldTitle(fold: Fold, send: (Action) -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .clickable(role = Role.Button) { send(fold.toggle) }
            .semantics { stateDescription = if (fold.isOpen) "expanded" else "collapsed" }
            .padding(start = 8.dp, end = 14.dp, top = 8.dp, bottom = 4.dp),
        Arrangement.spacedBy(4.dp),
        Alignment.CenterVertically,
    ) {
        Icon(if (fold.isOpen) Icons.Down else Icons.Right, contentDescription = null, Modifier.size(14.dp), palette.muted)
        Text(fold.title, color = fold.severity?.let(palette::findingColor) ?: palette.muted)
    }
}

@Composable
private fun ChoiceView(choice: Choice, send: (Action) -> Unit, modifier: Modifier) {
    FlowRow(
        modifier.fillMaxWidth().padding(horizontal = 22.dp),
        Arrangement.spacedBy(2.dp),
        itemVerticalAlignment = Alignment.CenterVertically,
    ) {
        Text(choice.name, color = LocalPalette.current.muted)
        for (option in choice.options) {
            val hint = if (option.hint == option.label) "${choice.name} ${option.label}" else option.hint
            ToolButton(hint, text = option.label, isOn = option.isOn == true) { send(option.action) }
        }
    }
}

@Composable
private fun CodeView(code: Code) {
    SelectionContainer(Modifier.padding(start = 22.dp, end = 14.dp, top = 2.dp, bottom = 6.dp)) {
        Text(
            code.text,
            Modifier
                .fillMaxWidth()
                .background(LocalPalette.current.raised, RoundedCornerShape(4.dp))
                .horizontalScroll(rememberScrollState())
                .padding(horizontal = 8.dp, vertical = 4.dp),
            fontFamily = FontFamily.Monospace,
            fontSize = 12.sp,
            softWrap = false,
        )
    }
}

@Composable
private fun PictureView(picture: Picture) {
    val colors = LocalPalette.current.pen
    Spacer(
        Modifier.fillMaxWidth().height(picture.height.dp).semantics { contentDescription = picture.name }.drawBehind {
            picture.draw(pen(), size.width.toDouble(), colors)
        },
    )
}

/** Shows [value] between its buttons: icons, as small as its text, come first. */
@Composable
internal fun ValueView(value: Value, send: (Action) -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier.fillMaxWidth()
            .background(if (value.isMarked) palette.accentSoft else Color.Transparent)
            .padding(start = 12.dp, end = 14.dp, top = 1.dp, bottom = 1.dp),
        horizontalArrangement = Arrangement.spacedBy(8.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        val (words, icons) = value.tools.partition { it.icon == null }
        for (tool in icons) {
            val icon = tool.icon?.vector ?: continue
            val press = Modifier.size(14.dp).clickable(role = Role.Button) { send(tool.action) }
            Tip(tool.hint) { Icon(icon, tool.hint, press, if (tool.isOn == true) palette.accent else palette.muted) }
        }
        value.color?.let { Box(Modifier.size(10.dp).background(palette.line(it), RoundedCornerShape(2.dp))) }
        NameText(value.name, Modifier.weight(1f), color = palette.muted)
        value.field?.let { FieldView(it, send) } ?: Tip(value.exact, Modifier.weight(0.8f)) {
            Text(value.text, fontWeight = FontWeight.Medium, maxLines = value.maxLines, overflow = TextOverflow.Ellipsis)
        }
        ButtonsView(words, send)
    }
}

/** Shows [trouble] with its place in a file, if it has one. */
@Composable
internal fun TroubleView(trouble: Trouble) {
    Row(Modifier.fillMaxWidth().padding(start = 12.dp, end = 14.dp, top = 4.dp, bottom = 4.dp), Arrangement.spacedBy(8.dp)) {
        Box(Modifier.width(58.dp)) { SeverityBadge(trouble.severity, trouble.word) }
        SelectionContainer(Modifier.weight(1f)) {
            Column {
                Text(trouble.text, maxLines = 8, overflow = TextOverflow.Ellipsis)
                if (trouble.place.isNotEmpty()) {
                    Text(
                        trouble.place,
                        color = LocalPalette.current.muted,
                        fontSize = 12.sp,
                        maxLines = 2,
                        overflow = TextOverflow.Ellipsis,
                    )
                }
                if (trouble.pointer.isNotEmpty()) Pointer(trouble.pointer)
            }
        }
    }
}

@Composable
private fun Pointer(text: String) {
    val scroll = rememberScrollState()
    LaunchedEffect(text, scroll.maxValue) { scroll.scrollTo((scroll.maxValue * placeOfCarets(text)).toInt()) }
    // Not wrapped: a wrapped line would not be above its carets.
    Text(
        text.take(MAX_LETTERS),
        Modifier.horizontalScroll(scroll),
        fontFamily = FontFamily.Monospace,
        fontSize = 11.sp,
        lineHeight = 14.sp,
        softWrap = false,
    )
}

/** Returns the place of the carets in the last line of [text], as a share of its longest line, 0 to 1. */
private fun placeOfCarets(text: String): Float =
    text.lastIndexOf(' ').minus(text.lastIndexOf('\n')).toFloat() / text.lines().maxOf { it.length }.coerceAtLeast(1)

private const val MAX_LETTERS = 2000

/** Shows [cards] beside each other, or below each other in a narrow place. */
@Composable
internal fun CardsView(cards: Cards, send: (Action) -> Unit) {
    BoxWithConstraints(Modifier.fillMaxWidth()) {
        if (maxWidth < NARROW) {
            Column { for (card in cards.cards) CardView(card, send) }
        } else {
            Row { for (card in cards.cards) CardView(card, send, Modifier.weight(1f)) }
        }
    }
}

/** Shows [card] in a frame. */
@Composable
internal fun CardView(card: Card, send: (Action) -> Unit, modifier: Modifier = Modifier) {
    val palette = LocalPalette.current
    val color = card.severity?.let(palette::findingColor) ?: palette.text
    val press = card.open?.let { open -> Modifier.clickable(role = Role.Button, onClickLabel = card.hint) { send(open) } } ?: Modifier
    Column(
        modifier
            .padding(horizontal = 12.dp, vertical = 4.dp)
            .fillMaxWidth()
            .background(card.severity?.let(palette::findingSoft) ?: palette.raised, RoundedCornerShape(6.dp))
            .then(press)
            .padding(if (card.isLarge) 12.dp else 8.dp),
        Arrangement.spacedBy(if (card.isLarge) 8.dp else 2.dp),
    ) {
        if (card.title.isNotEmpty()) NameText(card.title, fontSize = SIZE, fontWeight = FontWeight.SemiBold, cut = NameCut.MIDDLE)
        val size = if (card.isLarge) SIZE * 2 else SIZE
        if (card.headline.isNotEmpty()) {
            Text(
                card.headline,
                color = color,
                fontSize = size,
                fontWeight = FontWeight.Bold,
                lineHeight = size * LINE,
                maxLines = 3,
                overflow = TextOverflow.Ellipsis,
            )
        }
        for (line in card.lines) Text(line, fontSize = SIZE, lineHeight = SIZE * LINE, maxLines = 3, overflow = TextOverflow.Ellipsis)
    }
}

private val SIZE = 14.sp
private const val LINE = 1.25
private val NARROW = 360.dp
