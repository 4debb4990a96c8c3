"""Words that select_words.py leaves out, each list with its reason.

The lists were written by reading every candidate. Only familiar monosyllables stand here, for no
other word could be chosen. The tool leaves out the regular inflections of an offensive word
("...s", "...ed") with it.
"""

# Obscene, sexual, abusive or demeaning in their main or a common use. Never presented, and never
# the answer of a simulated listener.
OFFENSIVE = set("""
ass bitch breast bum butt chink cock crap crotch cum damn dike dope dumb freak groin grope hag
hick ho hoe hump lewd lust lynch nip nude poop prick prude puke pus queer rape scum sex slag slave
slob slut snatch sod sperm spook spunk stud tart teat thug tit tits whore womb
""".split())

# Innocent words with a sexual, abusive or drug sense that a participant may hear first. Never
# presented.
SUGGESTIVE = set("""
balls bang bone booze bra broad bung chick clap coke crack crutch dame darn drug dung dupe dwarf
fat flesh flog fruit gag gay ghoul gob god goon goose grunt hell hook horn hung hunk jack jerk
joint jug jugs junk knob lame lay lick loin lush mate moan moist mount muff mute nut nuts pad pant
peep pig pill pork pot probe prod prong punk queen rack ram ream rear rim roach rod rump screw
sexed shaft shoot shot skin slap slit smack smut snot snuff spade spank spit splurge stiff stoned
strap strip suck swine tail thigh thong thrash thrust tool toot tramp trash trick tripe wad wasp
weed whack whip whiz woo yank
""".split())

# Death, violence, illness, disgust: known words that need not be put before a participant.
DISTRESSING = set("""
ache bait belch bile bleed blood bomb bribe bruise burn burnt burp choke clot corpse crash crime
crypt cult curse cyst dead death die dirt doom dread drool drown drunk drunks fang fear fiend
fight filth flea fleas flu fraud gang gas gash germ gore gout grave grief grieve grouch gun hang
harm hate hearse hit hunt hurt jab jail kick kill knife lash lice louse lung mad maim mob morgue
mumps noose pain pest phlegm plague pound punch rage raid rot scalp scar scare scold scream shock
sick skull slain slang slime slur sneer snitch sob sore spew stab stank starve stench sting stink
strife stroke stunk theft thief thieve threat tick tomb trap trench vice wail war wart weep wept
whilst wound wreck wretch
""".split())

# Rare, dated, regional or technical; clipped forms and first names; letter names; or of doubtful
# sound or spelling. An ordinary participant may not know them at once. In doubt a word is here.
UNFAMILIAR = set("""
alms angst ark balk barb bard barge bark bash bask baud berth bill birch blab blanch blare blaze
blight blimp blithe blitz blob blot blotch blurb blurt bob bog bolt boo boom boon boor boos boost
bop botch bough bout brag braid braise bran brash brat brawl brawn bray brim brine brink brisk
broil bronze brooch brood brunt brusque brute buff bulge bulk bunk burr butte byte cad calf cam
cane cant cape carp carve cask caste caulk caw cede chafe chaff chap chaps char chaste chi chic
chide chime chimp chinks chirp chore chow chrome chuck chug chum churn cinch cite clack clad clam
clamp clan clang clank clasp claw cleat cleave clef cleft clerk clinch cling clink clique clog
clogged clone clout clove clump clutch cob cog coil coop cop cope cove coy crab crag cram crank
crass crate crave craze creak creed creek creep crepe crest crews crib croak crock crook croon
crouch crow crude crumb crunch crust crux cue cull cur curb curd curt czar dab dad daft dank dart
daub daunt daze deaf dean dearth deck deed deem deft deign delve dent dew din dine dip dirge disc
disk doer dole don dote douse drab drape drawl dredge drench drift drill drip droll drone droop
dross drought drudge dub duct dud dude duds duff dunk dusk dwell earl ebb eel eke elf elk elm err
etch ewe fad farce fawn feat feign fen fend fern feud fez fib fig filch fin finch fir fizz flail
flair flak flake flank flare flask flaunt flaw fleck fledged fleece fleet flex flick flinch fling
flint flit flock flop floss flounce flout flue fluff fluke flunk flux foal foam foe foil foist
folk fond font forge fowl fraught fray fret frieze frill fringe frisk fro frock frond froth frown
fudge fume fuse fuss fuzz gab gage gait gal gale gall gape garb gaunt gauze gawk gem gene gent
gibe gig gild gill gilt gin girth gist glade gland glare glaze gleam glean glee glen glib glide
glimpse glint gloat gloom gloss glue glum glut gnarl gnash gnat gnaw gnome gnu goad gong goo goof
gorge gouge gown graft gram graze grid grille grime grind gripe grit groan gross grouse grove grub
grudge gruff guild guile gulch gulf gull gulp gum gush gust gut guy gym hack hail hale ham hark
harp harsh hash haste hatch haunt hawk haze hearth heath heave hedge heed heir helm hem hemp hence
herb hew hike hilt hind hinge hip hiss hitch hive hoard hoarse hoax hock hoist hone hoof hoop hoot
hop hose hound hove howl hub huff hulk hull hum hunch hurl hush husk hutch ilk imp ire irk jade
jagged jamb jaunt jaw jay jazz jeer jell jest jibe jig jilt jinx jog jolt jot jut jute keel keen
keg kelp ken kiln kilt kin knack knead kneel knit knoll knot lace lad lag lair lance lap lapse
lard lark latch lath lathe laud launch lax leach leak lease leash ledge lee leech lens lest lieu
lilt lime limp link lint lisp lithe loaf loam loan loath loathe lob lobe lodge loft loll loom loon
loot lop lope lore lot loth lounge lug lull lump lunge lurch lure lurk lute lye lymph lyre mace
malt mange mar mare marsh mart mash maul mauve meek mere merge mesh mew mien mike mild mill mime
mince mink mirth miss mitt moat mock mod mode mold mole molt monk moor moose moot mop mope morn
moss moth mourn mow muck mug mulch mule mull mum munch muse mush musk mutt myth nab nag naught
nest newt niche nick nigh nil node noes nook norm notch noun nudge null numb nymph oar oath ode of
ohm opt ore ought ounce oust ox pact pal pall palm pang pap par parch pare parse pat pate pave paw
pawn pea peal peat peck peer peeve peg pelt pence perch perk pert pew pierce pike pinch pine pint
pitch plaid plank plaque plea plead pleat pledge plied plight plod plop plot plow ploy pluck plum
plumb plume plump plunge plush ply poach pod poise poke pomp pope porch pore pose pouch pounce
pout prance prank prawn preach preen prey prim prime primp prone prop prow prowl prune pry psalm
puck pulp pulse pun punt pup purge purr putt qua quack quail quaint quake quark quart quartz quash
quell quench quest queue quiche quill quip quirk raft rag rake ramp ranch range rank rant rap rapt
rash rasp rave ray raze realm reap reed reef reek reel reign rein reis rib rid ridge rife rift rig
rile rind rink rinse rip ripe rite roam rob robe rogue romp rook roost rouge rouse rout row rub
rude rue ruff rum rune ruse rush rust rut rye sac sack sag sage sake salve sane sap sash scab
scald scan scant scarce scarf scene scheme scoff scoop scoot scope scorch scorn scotch scourge
scout scowl scram scrape scratch scrawl screech scribe script scroll scrounge scrub scuff scythe
seam sear sect seek seep seer seethe shack shade sham shawl sheaf shear sheath sheathe sheen sheer
sheik shelve shield shin shire shirk shove shred shrewd shriek shrill shrine shroud shrub shrug
shuck shun shunt siege sieve sift sigh sill silt sin singe sip skein skew ski skid skim skimp skip
skit skulk skunk slab slack slam slant slat slate slay sled sleek sleet sleigh slick sling slog
slop slope slosh slot sloth slouch sludge slug sluice slum slump smash smear smirk smit smith
smock smog smudge smug snag snap snare snarl sneak sneeze snide sniff snip snipe snoop snooze
snore snort snout snub snug soak soot sop spa span spar spare spark sparse spate spawn spay spear
speck sphere sphinx spice spike spill spine spire spite splash splat spleen splice splint spoof
spool spore spout sprain sprawl spree sprint sprout spruce spry spud spur spurn spurt spy squad
squall squash squat squawk squeak squeal squelch squid squire squirt stack stag staid stain stake
stale stalk stall stance stanch starch stark staunch stave stealth steep steer stern stint stir
stock stoke stomp stoop stork stout stow strain strait strand stray streak stretch strew stride
strive strum strut stub stump stunt style suave sub sue suede suite sulk sup surf surge swab swamp
swan swarm swat swathe sway swear sweat sweep swell swerve swift swig swill swipe swirl swish
swoon swoop tab tack tact taint talc tale tan tang tar taunt taut teak team tee teem teethe tempt
tempts tens tense term terse thatch thaw thee thence thou thous thresh thrice thrift thrive throb
throng thud thump thwart thy thyme tier tiff till tilt tin ting tinge tint toad toe toil toll tome
ton tong tonne torque toss tot tote tout tow tract trait trance traps tread trek trill trim trite
troll troop trough trounce troupe trout truce trudge trump trunk tsar tuck tuft tug turf tusk
twang tweak tweed tweet twig twin twine twinge twirl twist twitch typed urge urn vague vain vane
vat vault veal veer veil vent verge verse verve vex vie vile vine vise vogue void volt vouch vow
waft wag wage waif wake wan wand wane ward warn warp watt wean wed wedge weld welt wharf whence
whet whim whine whirl whisk whoop wick wield wig wilt wince winch wisp wist wit woe wont woof
wrath wreak wreath wren wrench wrest wring writ writhe wry yak yam yap yearn yelp yen yield yoke
yolk zeal zest zinc
""".split())

# Interjections, titles, clippings and other items that are not quite words.
NOT_QUITE_WORDS = set("""
ad ads ah amp aye blog con eh gee gosh ha hey hi ho huh lab ma ms non oh ouch pa pep pi pro prom
psych pub re rev sec sir ugh whew whoa wow yuck
""".split())

# Irregular past forms, participles, plurals and inflected pronouns and verbs. They are no part of
# the reference population either.
IRREGULAR_FORMS = set("""
are ate bade beat been bent bit bled blown bore born borne bought bound bred broke brought built
burnt came cast caught choirs chose clung crept crofts cut dealt did does done drank drawn dregs
drew drove drunk dudes dug dwelt fed feet fell felt fled flew flown flung fought found froze gave
geese gone got grew ground grown had has heard held hewn hid housed hung is jeers kept kinks knelt
knew known laid lain leapt learnt led left lent lice lit lost made meant men met mice mouthed
mouths mows mumps paid pled ran rang rent rode rose rung said sang sank sat saw seen sent sewn
shears shed shoals shod shone shook shorn shot showed shown shrank shrunk shut sires sirs slain
slept slew slid slit slung smelt snuck sold sought sown spat sped spent spilt split spoke sprang
sprung spun stank stole stood stove strewn strode strove struck strung stuck stung stunk suds sung
sunk swam swept swore sworn swum swung taught teeth thought threw throve thrown told took tore
torn trod was went wept were whose woke won wore worn wound wove wrote wrought wrung
""".split())
