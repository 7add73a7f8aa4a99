"use strict";(()=>{var Bt,eg,MS,pr,Fd,Jl,tg,ql,ng,kd,Ud,wS,Ia=Symbol.for("pv"),Zl={},Kl=[],TS=/^m(i|n|o|s|text|space)$/,Od=Array.isArray,Bd=Kl.slice,Or=Object.assign;function kr(n){n&&n.parentNode&&n.remove()}function ig(n,e,t){var i,s,r,o={},a=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:o[r]=e[r];return a>2&&(o.children=a>3?Bd.call(arguments,2):t),Pa(n,o,i,s,null)}function Pa(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Ia,__v:s||++eg,__i:-1,__u:0};return!s&&Bt.vnode&&Bt.vnode(r),r}function Ze(n){return n.children}function bo(n,e){this.props=n,this.context=e,this.__g=0}function mr(n,e){if(e==null)return n.__&&mr(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:mr(n)}function AS(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Or({constructor:Ia},t)).__v=t.__v+1,Bt.vnode&&Bt.vnode(e),Vd(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||mr(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,cg(s,e,r),t.__=t.__e=null,e.__e!=i&&sg(e))}function sg(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),sg(n)}function jm(n){(8&n.__g||(n.__g|=8,pr.push(n),Jl++))&&Fd==Bt.debounceRendering||((Fd=Bt.debounceRendering)||queueMicrotask)(rg)}function rg(){try{for(var n,e=1;pr.length;)pr.length>e&&pr.sort(tg),n=pr.shift(),e=pr.length,8&n.__g&&AS(n)}finally{(Jl=pr.length)&&(Fd||queueMicrotask)(rg)}}function og(n,e,t,i,s,r,o,a,l,c,u){var f,d,p,m,v,_,g=i.__k||Kl,y=e.length;for(l=ES(t,e,g,l,y),f=0;f<y;f++)(p=t.__k[f])!=null&&(d=~p.__i&&g[p.__i]||Zl,p.__i=f,_=Vd(n,p,d,s,r,o,a,l,c,u),m=p.__e,(d.ref!=p.ref||8&d.__u)&&(d.ref&&zd(d.ref,null,p,d),p.ref&&u.push(p.ref,p.__c||m,p)),v=v||m,4&p.__u?(l=ag(p,l,n,!d.__v),d.__e&&(d.__e=null)):typeof p.type=="function"&&_!==void 0?l=_:m&&(l=m.nextSibling),p.__u&=-21);return t.__e=v,l}function ES(n,e,t,i,s){var r,o,a,l,c,u,f,d,p,m=t.length,v=m,_=0,g=0,y=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=y[r]=Pa(null,o):Od(o)?o=y[r]=Pa(Ze,{children:o}):o.constructor===Ia&&o.__b?o=y[r]=Pa(o.type,o.props,o.key,o.ref,o.__v):y[r]=o,l=r+_,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=CS(o,t,l,v))&&(v--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?_--:c==l+1?_++:c!=l&&(c>l?_--:_++,g=1)):(~c||(s>m?_--:s<m&&_++),typeof o.type!="function"&&(o.__u|=4))):y[r]=null;if(g){for(u=[],f=[],r=0;r<s;r++)if((o=y[r])&&16&o.__u){for(_=0,d=u.length;_<d;)u[p=_+d>>1]<o.__i?_=p+1:d=p;u[_]=o.__i,f[r]=_+1}for(_=u.length;r--;)f[r]&&(f[r]==_?_--:y[r].__u|=4)}if(v)for(r=0;r<m;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=mr(a)),Gd(a,a));return i}function ag(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=ag(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=mr(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function CS(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Qm(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Xl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Qm(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Qm(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Ud[e]||(Ud[e]=RS(e)),(n.__a||(n.__a={}))[e]=kd,r=e!=(e=e.replace(ng,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function RS(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[ql]==null)e[ql]=kd++;else if(e[ql]<this.__a[n])return;return t(Bt.event?Bt.event(e):e)}}}function Vd(n,e,t,i,s,r,o,a,l,c){var u,f,d,p,m,v,_,g,y,E,M,I,C,b,A,H,F,D,G=e.type;if(e.constructor!==Ia)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,f=r=[],u.nodeType==8?a=Yl(u,r):r.push(u),a=r[0]||a),(u=Bt.__b)&&u(e);e:if(typeof G=="function"){d=o.length;try{if(g=e.props,y=(u=G.prototype)&&u.render,E=(u=G.contextType)&&i[u.__c],M=u?E?E.props.value:u.__:i,(p=t.__c)?(e.__c=p,2&p.__g&&(p.__g|=1)):(y?e.__c=p=new G(g,M):(e.__c=p=new bo(g,M),p.constructor=G,p.render=IS),E&&E.sub(p),p.state||(p.state={}),p.__n=i,p.__g|=8,p.__h=[],p.__k=[]),y&&(p.__s||(p.__s=p.state),G.getDerivedStateFromProps&&(p.__s==p.state&&(p.__s=Or({},p.__s)),Or(p.__s,G.getDerivedStateFromProps(g,p.__s)))),m=p.props,v=p.state,p.__v=e,t.__c){if(g!==m&&y&&!G.getDerivedStateFromProps&&p.componentWillReceiveProps&&p.componentWillReceiveProps(g,M),e.__v==t.__v&&!(8&p.__g)||!(4&p.__g)&&p.shouldComponentUpdate&&p.shouldComponentUpdate(g,p.__s,M)===!1){e.__v!=t.__v&&(p.props=g,p.state=p.__s,p.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(V){V&&(V.__=e)}),Kl.push.apply(p.__h,p.__k),p.__k=[],p.__h.length&&o.push(p),a=mr(t);break e}p.componentWillUpdate&&p.componentWillUpdate(g,p.__s,M),y&&p.componentDidUpdate&&p.__h.push(function(){p.componentDidUpdate(m,v,_)})}else y&&!G.getDerivedStateFromProps&&p.componentWillMount&&p.componentWillMount(),y&&p.componentDidMount&&p.__h.push(p.componentDidMount);p.context=M,p.props=g,p.__P=n,p.__g&=-5,I=Bt.__r,C=y?25:0;do p.__g&=-9,I&&I(e),u=p.render(p.props,p.state=p.__s,p.context);while(8&p.__g&&++C<25);y&&(Kl.push.apply(p.__h,p.__k),p.__k=[]),p.state=p.__s,p.getChildContext&&(i=Or({},i,p.getChildContext())),y&&t.__c&&p.getSnapshotBeforeUpdate&&(_=p.getSnapshotBeforeUpdate(m,v)),b=u&&u.type===Ze&&u.key==null?u.props.children:u,g.__P&&(u=a,s=(n=g.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(V){V&&Gd(V,V)}),t.__k=null),a=t.__k?mr(t,0):null),a=og(n,Od(b)?b:[b],e,t,i,s,r,o,a,l,c),g.__P&&(e.__e=null,a=u),e.__u&=-161,f&&f.some(kr),p.__h.length&&o.push(p),1&p.__g&&(p.__g&=-4)}catch(V){if(o.length=d,e.__v=null,l||r)if(V&&V.then){if(e.__u|=128|l,r){for(~(F=r.indexOf(a||void 0))||(F=r.length);(D=r[F-1])&&D.nodeType==8;)F--;for(;F<r.length;F++)if(D=r[F])if(r[F]=null,A){if(D==H)break}else{if(D.nodeType!=8)break;D.data.startsWith("$s")&&(H=Yl(A=D))}}if(!A){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;A=a}(u=Yl(A=e.__c.__z||(e.__c.__z=A)))?(e.__e=A,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(kr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),V&&V.then||lg(e),Bt.__e(V,e,t)}}else a=e.__e=PS(t.__e,e,t,i,s,r,o,l,c,n);return(u=Bt.diffed)&&u(e),a}function Yl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function lg(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(lg))}function cg(n,e,t){for(var i=0;i<t.length;)zd(t[i++],t[i++],t[i++]);Bt.__c&&Bt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Bt.__e(r,s.__v)}})}function PS(n,e,t,i,s,r,o,a,l,c){var u,f,d,p,m,v,_,g,y=t.props||Zl,E=e.props,M=e.type;if(M=="svg"?s="http://www.w3.org/2000/svg":M=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((m=r[u])&&(M?m.localName==M:m.nodeType==3)){n=m,r[u]=null;break}}if(!n){if(g=c.ownerDocument||document,!M)return g.createTextNode(E);n=g.createElementNS(s,M,E.is?E:c),a&&(Bt.__m&&Bt.__m(e,r),a=!1),r=null}if(M){if(c=M=="template"&&n.content||n,r=M=="textarea"&&E.defaultValue!=null?null:r&&Bd.call(c.childNodes),!a&&r)for(y={},u=0;u<n.attributes.length;u++)y[(m=n.attributes[u]).name]=m.value;for(u in y)m=y[u],u=="dangerouslySetInnerHTML"?d=m:u=="children"||u in E||u=="value"&&"defaultValue"in E||u=="checked"&&"defaultChecked"in E||Xl(n,u,null,m,s);for(u in E)m=E[u],u=="children"?p=m:u=="dangerouslySetInnerHTML"?f=m:u=="value"?v=m:u=="checked"?_=m:a&&typeof m!="function"||y[u]===m||Xl(n,u,m,y[u],s);f?(a||d&&(f.__html==d.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(d&&(n.textContent=""),(M=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&TS.test(M))&&(s="http://www.w3.org/1999/xhtml"),og(c,Od(p)?p:[p],e,t,i,s,r,o,r?r[0]:t.__k&&mr(t,0),a,l),r&&r.some(kr)),a&&M!="textarea"||(u="value",M=="progress"&&v==null?n.removeAttribute(u):v==null||v===n[u]&&(M!="progress"||v)||Xl(n,u,v,y[u],s),u="checked",_!=null&&_!=n[u]&&Xl(n,u,_,y[u],s))}else y===E||a&&n.data==E||(n.data=E);return n}function zd(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Bt.__e(s,t)}}function Gd(n,e,t){var i,s,r,o;if(Bt.unmount&&Bt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||zd(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Bt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Gd(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Yl(i,r=[]))&&(i==n.__e&&r.some(kr),kr(s),kr(i)),t||kr(n.__e),n.__e=n.__c=n.__=null}function IS(n,e,t){return this.constructor(n,t)}function La(n,e){var t,i,s,r;Bt.__&&Bt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Pa(Ze,{children:[n]}),s=[],r=[],Vd(e,e.__k,i||Zl,Zl,e.namespaceURI,i?null:e.firstChild?Bd.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),cg(s,e.__k,r),e.__k.props.children=null}Bt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Jl=0,n}},eg=0,MS=function(n){return n!=null&&n.constructor===Ia},bo.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Or({},this.state)),typeof n=="function"&&(n=n(Or({},t),this.props)),n&&(Or(t,n),this.__v&&(e&&this.__k.push(e),jm(this)))},bo.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),jm(this))},bo.prototype.render=Ze,pr=[],Jl=0,tg=function(n,e){return n.__v.__b-e.__v.__b},ql=Symbol(),ng=/(PointerCapture)$|Capture$/i,kd=0,Ud={},wS=0;async function ug(n){let e=document.getElementById(`block-${n}`)?.textContent;if(e==null)throw new Error(`the report has no block ${n}`);let t=Uint8Array.from(atob(e.trim()),s=>s.charCodeAt(0)),i=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(i).arrayBuffer())}async function hg(n){return JSON.parse(new TextDecoder().decode(await ug(n)))}var jl=class n{constructor(e){this.bytes=e;let t=new DataView(e.buffer,e.byteOffset).getUint32(0,!0);this.trace=JSON.parse(new TextDecoder().decode(e.subarray(4,4+t))),this.start=Math.ceil((4+t)/4)*4}bytes;trace;start;static async of(e){return new n(await ug(e))}floats(e){let t=this.bytes.byteOffset+this.start+e.offset;return new Float32Array(this.bytes.buffer.slice(t,t+4*e.count))}steps(e){let t=e.min.length,i=new Float32Array(e.frames*t),s=this.start+e.offset;for(let r=0;r<t;++r){let o=0;for(let a=0;a<e.frames;++a){let l=0,c=0,u;do u=this.bytes[s++]??0,l|=(u&127)<<c,c+=7;while(u&128);o+=l>>>1^-(l&1),i[a*t+r]=o===0?NaN:e.min[r]+e.step[r]*(o-1)}}return i}frames(e){return{time:this.floats(e.time),position:this.steps(e.position),orientation:this.steps(e.orientation)}}};var dg="cylon-theme",Hd=new Set,fg=matchMedia("(prefers-color-scheme: dark)"),Ql=LS(),Wd=!1;function LS(){try{let n=localStorage.getItem(dg);return n==="light"||n==="dark"?n:"auto"}catch{return"auto"}}function Da(){let n=!Wd&&(Ql==="dark"||Ql==="auto"&&fg.matches);document.documentElement.dataset.theme=n?"dark":"light";for(let e of Hd)e()}function pg(){return Ql}function mg(n){Ql=n;try{localStorage.setItem(dg,n)}catch{}Da()}function So(n){return Hd.add(n),()=>Hd.delete(n)}function si(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()}function ec(){fg.addEventListener("change",Da),addEventListener("beforeprint",()=>(Wd=!0,Da())),addEventListener("afterprint",()=>(Wd=!1,Da())),Da()}var Mo,Mn,$d,gg,Xd=Object.is,Fa=0,Tg=[],qd=[],gn=Bt,_g=gn.__b,xg=gn.__r,yg=gn.diffed,vg=gn.__c,bg=gn.unmount,Sg=gn.__;function tc(n,e){gn.__h&&gn.__h(Mn,n,Fa||e),Fa=0;var t=Mn.__H||(Mn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function lt(n){return Fa=1,DS(Eg,n)}function DS(n,e,t){var i=tc(Mo++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Eg(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Xd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=Mn,!Mn.__f)){Mn.__f=!0;var s=Mn.shouldComponentUpdate;Mn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(d){d.__N&&(c=!0,Xd(d.__[0],d.__N[0])||(u=!0))}),s){var f=s.call(this,r,o,a);return c?f||u:f}return!c||u}}return i.__}function Rt(n,e){var t=tc(Mo++,3);!gn.__s&&Jd(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,Mn.__H.__h.push(t))}function bi(n,e){var t=tc(Mo++,4);!gn.__s&&Jd(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,Mn.__h.push(t))}function Vt(n){return Fa=5,He(function(){return{current:n}},[])}function He(n,e){var t=tc(Mo++,7);return Jd(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Ag(n,e){return Fa=8,He(function(){return n},e)}function NS(){var n;do{for(;n=qd.shift();)try{Na(n)}catch(t){gn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Tg.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Na),e.__h.some(Yd),e.__h=[]}catch(t){e.__h=[],gn.__e(t,n.__v)}}}while(qd.length)}gn.__b=function(n){Mn=null,_g&&_g(n)},gn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Sg&&Sg(n,e)},gn.__r=function(n){xg&&xg(n),Mo=0;var e=(Mn=n.__c).__H;e&&($d==Mn?Mn.__h=[]:(e.__h.some(Na),e.__h.some(Yd),Mo=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),$d=Mn},gn.diffed=function(n){yg&&yg(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&wg(Tg.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),$d=Mn=null},gn.__c=function(n,e){e.some(function(t){try{t.__h.some(Na),t.__h=t.__h.filter(function(i){return!i.__||Yd(i)})}catch(i){t.__h=[function(){throw i}]}}),vg&&vg(n,e)},gn.unmount=function(n){bg&&bg(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,wg(qd.push(s))}else Na(s)}catch(r){e=r}}),i.__H=void 0,e&&gn.__e(e,i.__v))};var Mg=typeof requestAnimationFrame=="function";function FS(n){var e,t=function(){clearTimeout(i),Mg&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Mg&&(e=requestAnimationFrame(t))}function wg(n){n!=1&&gg==gn.requestAnimationFrame||((gg=gn.requestAnimationFrame)||FS)(NS)}function Na(n){var e=Mn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),Mn=e}function Yd(n){var e=Mn;n.__c=n.__(),Mn=e}function Jd(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Xd(t,n[i])})}function Eg(n,e){return typeof e=="function"?e(n):e}function Zd(n){return Object.fromEntries(new URLSearchParams(n.replace(/^#/,"")))}function nc(n){let e=Object.entries(n).filter(([,t])=>t!=="");return`#${new URLSearchParams(e).toString()}`}var Kd=new Set,ns={};function Cg(){for(let n of Kd)n(ns)}function Rg(){ns=Zd(location.hash),addEventListener("hashchange",()=>{nc(Zd(location.hash))!==nc(ns)&&(ns=Zd(location.hash),Cg())})}function Ua(){return ns}function wn(n,e=!1){ns=Object.fromEntries(Object.entries({...ns,...n}).filter(([,i])=>i!==""));let t=nc(ns);try{e?history.pushState(null,"",t):history.replaceState(null,"",t)}catch{location.hash=t}Cg()}function Vn(){let[n,e]=lt(ns);return bi(()=>(Kd.add(e),e(ns),()=>{Kd.delete(e)}),[]),n}var Pg={cell:"",engine:"",scheme:"",dt:"",other:"",claims:"",t:""};function ws(n){return{...Pg,cell:n.scenario,engine:n.engine,scheme:n.integrator,dt:n.dt}}function gr(n){return{...Pg,section:n}}function Yn(n){return nc({...ns,...n})}function Ig(n){return n.cell===void 0?null:{scenario:n.cell,engine:n.engine??"",integrator:n.scheme??"",dt:n.dt??""}}function ri(n){let e=Math.round(n*10)/10;return(e<0?"-":"+")+Math.abs(e).toFixed(1)}function De(n,e=4){if(n==null)return"not finite";if(!Number.isFinite(n))return Number.isNaN(n)?"NaN":n>0?"inf":"-inf";if(n===0)return"0";let[t="0",i="0"]=n.toExponential(e-1).split("e"),s=Number(i);return s<-4||s>=e?`${Lg(t)}e${s}`:Lg(n.toFixed(Math.max(0,e-1-s)))}function Lg(n){return n.includes(".")?n.replace(/\.?0+$/,""):n}function zn(n,e,t=4){let i=typeof n=="string"?n:De(n,t);return e?`${i} ${e}`:i}function ic(n){return n.interval?zn(`${De(n.measured)} [${De(n.interval[0])}, ${De(n.interval[1])}]`,n.unit):zn(n.measured,n.unit)}var US=[[1,""],[.001,"m"],[1e-6,"\xB5"],[1e-9,"n"],[1e-12,"p"]];function Jn(n){if(n==null||!Number.isFinite(n))return"not measured";let[e,t]=US.find(([i])=>Math.abs(n)>=i)??[1e-12,"p"];return n===0?"0 s":`${De(n/e,3)} ${t}s`}function on(n,e,t=`${e}s`){return`${n} ${n===1?e:t}`}var $n={pass:{glyph:"\u2713",meaning:"within tolerance",tone:"pass"},unsupported:{glyph:"\u2013",meaning:"the engine refuses the scene",tone:"unsupported"},undecided:{glyph:"?",meaning:"its uncertainty holds the tolerance",tone:"undecided"},"low-quality":{glyph:"~",meaning:"within ten times the tolerance",tone:"low-quality"},fail:{glyph:"\u2717",meaning:"beyond that",tone:"fail"},"non-finite":{glyph:"\u221E non-finite",meaning:"NaN or infinite",tone:"broken"},timeout:{glyph:"\u25F7 timeout",meaning:"no end before the deadline",tone:"broken"},crash:{glyph:"\u2620\uFE0E crash",meaning:"the worker died",tone:"broken"},protocol:{glyph:"\u203D protocol",meaning:"the worker sent garbage",tone:"broken"}},jd=Object.keys($n);function Gi(n){return jd.indexOf(n)}function Tn(n){return n==="pass"||n==="low-quality"||n==="fail"||n==="undecided"}function is(n,e){return n===null||e===null||!Number.isFinite(n)?-99:n===0?99:e===0?-99:Math.min(99,Math.max(-99,Math.log10(e/n)))}function ss(n){return!n.as_expected}function ka(n,e){let t=Gi(n.status)-Gi(e.status);return t!==0||!Tn(n.status)?t:is(e.measured,e.allowed)-is(n.measured,n.allowed)}function sc(n){return[...n].sort((e,t)=>Number(ss(t))-Number(ss(e))||ka(t,e))}var kS=Symbol.for("pv"),OS=0;function h(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:kS,__v:--OS,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Bt.vnode&&Bt.vnode(c),c}function rs({status:n,word:e=!0}){let{glyph:t,tone:i}=$n[n],s=t.includes(" ");return h("span",{class:`status ${i}`,children:e&&!s?`${t} ${n}`:t})}function Ws({text:n="!"}){return h("strong",{class:"differs",children:[h("span",{"aria-hidden":"true",children:n}),h("span",{class:"unseen",children:"differs from expected.toml"})]})}function Dg(n,e,t){let i=Tn(n)&&e!==null?`, ${ri(e)} digits`:"";return`${n}${i}${t?", differs from expected.toml":""}`}var Ng=new RegExp(["[\\u0000-\\u001f\\u007f-\\u009f]","[\\u00ad\\u061c\\u180e\\u200b-\\u200f\\u2028-\\u202e\\u2060-\\u2069\\ufeff\\ufff9-\\ufffb]","[\\ud800-\\udbff](?![\\udc00-\\udfff])|(?<![\\ud800-\\udbff])[\\udc00-\\udfff]"].join("|"),"g");function Fg(n){return`\\u${n.charCodeAt(0).toString(16).padStart(4,"0")}`}function te(n){return n.replace(Ng,Fg)}function Ug(n){return n.replace(/\r\n/g,`
`).replace(Ng,e=>e===`
`||e==="	"?e:Fg(e))}var Qd=4096;function kg(n){let[e,t]=lt(!1),i=!e&&n.length>Qd;return{shown:i?n.slice(0,Qd):n,rest:i?n.length-Qd:0,open:()=>t(!0)}}function Og({rest:n,open:e}){if(n===0)return null;let t=`${n.toLocaleString("en")} more characters`;return h(Ze,{children:[h("button",{type:"button",class:"more",onClick:e,children:["show ",t]}),h("span",{class:"on-paper",children:["(",t," are not printed)"]})]})}function Ht({text:n}){let{shown:e,rest:t,open:i}=kg(n);return h(Ze,{children:[h("bdi",{children:te(e)}),h(Og,{rest:t,open:i})]})}function wo({text:n,label:e}){let{shown:t,rest:i,open:s}=kg(n);return h(Ze,{children:[h("pre",{class:"output",tabIndex:0,role:"region","aria-label":e,children:Ug(t)}),h(Og,{rest:i,open:s})]})}var Bg=[[],[9,4],[2,3],[9,3,2,3],[15,4],[5,2]],Vg=[[[.9,0],[.78,.45],[.45,.78],[0,.9],[-.45,.78],[-.78,.45],[-.9,0],[-.78,-.45],[-.45,-.78],[0,-.9],[.45,-.78],[.78,-.45]],[[-.8,-.8],[.8,-.8],[.8,.8],[-.8,.8]],[[0,-1.05],[1,.75],[-1,.75]],[[0,-1.15],[1.15,0],[0,1.15],[-1.15,0]],[[0,1.05],[1,-.75],[-1,-.75]],[[-.35,-1],[.35,-1],[.35,-.35],[1,-.35],[1,.35],[.35,.35],[.35,1],[-.35,1],[-.35,.35],[-1,.35],[-1,-.35],[-.35,-.35]],[[0,-1.1],[1.05,-.34],[.65,.9],[-.65,.9],[-1.05,-.34]]];function Hi(n){return{color:`--series-${n%8+1}`,dash:Bg[n%Bg.length],marker:n%Vg.length}}function To(n,e,t,i){return`M${Vg[n].map(([r,o])=>`${(e+i*r).toFixed(2)},${(t+i*o).toFixed(2)}`).join("L")}Z`}function zg(n,e,t,i,s){let{marker:r,color:o}=Hi(e);n.fillStyle=si(o),n.fill(new Path2D(To(r,t,i,4*s)))}function Ts({style:n,faint:e=!1}){let t=Hi(n),i=`var(${t.color})`;return h("svg",{class:"sample",width:"40",height:"14","aria-hidden":"true",children:[h("line",{x1:"0",x2:"40",y1:"7",y2:"7",stroke:i,"stroke-width":e?1:2,"stroke-dasharray":t.dash.join(" ")}),h("path",{d:To(t.marker,20,7,e?3:4.5),fill:e?"var(--ground)":i,stroke:i})]})}function Gg(n,e,t){return n.map((i,s)=>({verdict:i,index:s,claim:e?.claims.find(r=>r.label===i.claim)??null,curve:t.find(r=>r.claim===i.claim)??null}))}function Hg({until:n}){return n===null?"":`, until ${De(n)} s`}function BS({claim:n,verdict:e}){return n?.at_least==null?h(Ze,{children:["truth: ",h(VS,{claim:n,verdict:e})]}):h(Ze,{children:["must change by at least ",zn(n.at_least,n.unit)+Hg(n)]})}function VS({claim:n,verdict:e}){let t=e.truth_error===null?"":`known to ${zn(e.truth_error,e.unit)}`;if(n===null)return h(Ze,{children:t||"not told"});let i=n.follows===""?"its initial value":n.follows,s=n.source?`: ${n.source}`:"",r=Hg(n);return h(Ze,{children:te(i+s)+(t?` (${t})`:"")+`, ${e.evidence}`+r})}function zS({curve:n,verdict:e}){let t=n?.first_violation;return t?h(Ze,{children:[De(t.time)," s, step ",t.step,": ",zn(t.value,n.unit)]}):e.first_bad_step!==null?h(Ze,{children:["not finite from step ",e.first_bad_step]}):h(Ze,{children:n?"none":"not recorded"})}function GS({row:{verdict:n,claim:e}}){return h("ul",{class:"notes",children:[n.detail?h("li",{children:h(Ht,{text:n.detail})}):null,n.expected_reason?h("li",{children:["expected.toml: ",h(Ht,{text:n.expected_reason})]}):null,h("li",{children:h(BS,{claim:e,verdict:n})}),h("li",{children:["tolerance: ",h(Ht,{text:n.reason}),n.tolerance_scale===1?"":`; all times ${n.tolerance_scale}`,n.spread===null?"":`; runs that start an ulp apart end ${zn(n.spread,n.unit)} apart`]})]})}function HS({row:n,shown:e,toggle:t,reasons:i}){let{verdict:s,curve:r,index:o}=n;return h("tbody",{class:ss(s)?"differing":void 0,children:[h("tr",{children:[h("td",{class:"on-screen",children:h("label",{children:[h("input",{type:"checkbox",checked:e,disabled:!r,onChange:()=>t(o)}),h("span",{class:"unseen",children:["show the error curve of ",te(s.claim)]}),r?h(Ts,{style:o}):null]})}),h("td",{children:h(rs,{status:s.status})}),h("th",{scope:"rowgroup",children:te(s.claim)}),h("td",{class:"number",children:Tn(s.status)?ic(s):""}),h("td",{class:"number",children:s.allowed===null?"":zn(s.allowed,s.unit)}),h("td",{class:"number",children:Tn(s.status)?ri(is(s.measured,s.allowed)):""}),h("td",{class:"number",children:h(zS,{curve:r,verdict:s})}),h("td",{class:"expected",children:[s.expected_size===null?s.expected:`${zn(s.expected_size,s.unit)} within \xD7${s.expected_within}`,ss(s)?h(Ws,{text:"differs"}):null]})]}),i?h("tr",{children:[h("td",{class:"on-screen"}),h("td",{}),h("td",{colSpan:6,children:h(GS,{row:n})})]}):null]})}var WS=["status","claim","measured","allowed","digits","first violation","expected"];function Wg({rows:n,shown:e,toggle:t}){let[i,s]=lt(!1),[r,o]=lt(!0),a=He(()=>i?[...n].sort((l,c)=>ka(c.verdict,l.verdict)):n,[n,i]);return h("section",{"aria-labelledby":"claims-heading",children:[h("h3",{id:"claims-heading",children:"Claims"}),h("label",{class:"on-screen",children:[h("input",{type:"checkbox",checked:i,onChange:()=>s(!i)})," worst first"]})," ",h("label",{class:"on-screen",children:[h("input",{type:"checkbox",checked:r,onChange:()=>o(!r)})," truths, bounds and reasons"]}),h("div",{class:"scroll claims",tabIndex:0,role:"region","aria-label":"Claims of this cell",children:h("table",{children:[h("thead",{children:h("tr",{children:[h("th",{scope:"col",class:"on-screen",children:"curve"}),WS.map(l=>h("th",{scope:"col",children:l},l))]})}),a.map(l=>h(HS,{row:l,shown:e.has(l.index),toggle:t,reasons:r},l.index))]})})]})}async function $S(n,e){try{return await navigator.clipboard.writeText(n),!0}catch{return e&&getSelection()?.selectAllChildren(e),!1}}function rc({text:n}){let e=Vt(null),[t,i]=lt(""),s=async()=>i(await $S(n,e.current)?"copied":"selected: copy it with the keyboard");return h("p",{class:"command",children:[h("code",{ref:e,children:te(n)})," ",h("button",{type:"button",onClick:s,"aria-label":`Copy the command ${te(n)}`,children:"copy"})," ",h("span",{role:"status",children:t})]})}var oc=class{constructor(e,t){this.whole=e;this.pinned=this.within(t)}whole;pinned;hovered=null;zoomed=null;running=!1;listeners=new Set;get time(){return this.hovered??this.pinned}get pin(){return this.pinned}set pin(e){this.pinned=this.within(e),this.announce()}hover(e){let t=e===null||this.running?null:this.within(e);t!==this.hovered&&(this.hovered=t,this.announce())}get window(){return this.zoomed}set window(e){let i=e!==null&&e[0]<=this.whole[0]&&e[1]>=this.whole[1]?null:e;i?.[0]===this.zoomed?.[0]&&i?.[1]===this.zoomed?.[1]||(this.zoomed=i,this.announce())}lookCloser(){let[e,t]=this.zoomed??this.whole,i=(t-e)/4,s=Math.min(t-i,Math.max(e+i,this.time));this.window=[s-i,s+i]}listen(e){return this.listeners.add(e),()=>{this.listeners.delete(e)}}within(e){return Math.min(this.whole[1],Math.max(this.whole[0],e))}announce(){for(let e of this.listeners)e()}};function ac(n){let[,e]=lt(0);return Rt(()=>{let t=0,i=n.listen(()=>{t||=requestAnimationFrame(()=>{t=0,e(s=>s+1)})});return()=>{i(),cancelAnimationFrame(t)}},[n]),n.time}function lc(n){let e={least:1/0,leastAt:0,greatest:-1/0,greatestAt:0,zeros:0,lost:0,lostAt:null};for(let t=0;t<n.value.length;++t){let i=n.value[t],s=n.time[t];if(!Number.isFinite(i)){++e.lost,e.lostAt??=s;continue}i===0&&++e.zeros,i<e.least&&([e.least,e.leastAt]=[i,s]),i>e.greatest&&([e.greatest,e.greatestAt]=[i,s])}return Number.isFinite(e.greatest)?e:null}function As(n,e){if(n.length===0)return-1;let t=0,i=n.length-1;for(;t<i;){let s=t+i>>1;n[s]<e?t=s+1:i=s}return t>0&&e-n[t-1]<=n[t]-e?t-1:t}function $g(n){let e=1/0;for(let t of n){for(let i=0;i<t.value.length;++i){let s=t.value[i];s>0&&s<e&&(e=s)}t.allowed!=null&&t.allowed>0&&(e=Math.min(e,t.allowed))}return Number.isFinite(e)?10**(Math.floor(Math.log10(e))-1):1e-16}function Xg(n,e){let t=new Set;for(let o of n)for(let a=0;a<o.time.length;++a)t.add(o.time[a]);let i=[...t].sort((o,a)=>o-a),s=new Map(i.map((o,a)=>[o,a])),r=n.map(o=>{let a=new Array(i.length).fill(void 0);for(let l=0;l<o.time.length;++l){let c=s.get(o.time[l]),u=o.value[l],f=Number.isFinite(u)?e===null?u:Math.max(u,e):null,d=a[c];(d===void 0||f!==null&&(d===null||Math.abs(f)>Math.abs(d)))&&(a[c]=f)}return a});return[i,...r]}function qg(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;++i){let s=n[i];Number.isFinite(s)&&(s<e[i%3]&&(e[i%3]=s),s>t[i%3]&&(t[i%3]=s))}return e.every(Number.isFinite)?{min:[e[0],e[1],e[2]],max:[t[0],t[1],t[2]]}:null}function cc({min:n,max:e}){return Math.hypot(e[0]-n[0],e[1]-n[1],e[2]-n[2])}function XS(n,e){let[t,i]=[n.min.map((s,r)=>Math.min(s,e.min[r])),n.max.map((s,r)=>Math.max(s,e.max[r]))];return{min:[t[0],t[1],t[2]],max:[i[0],i[1],i[2]]}}function Yg(n,e){let t=n?qg(n.position):null;if(t&&n.time.length>1)return t;let s=e.flatMap(r=>r?[qg(r.position)]:[]).filter(r=>r!==null).sort((r,o)=>cc(r)-cc(o))[0]??null;return s&&t?XS(s,t):s??t}function qS(n,e,t,i){let s=As(n.time,i),r=n.time[s]>i?Math.max(0,s-1):s,o=Math.min(n.time.length-1,r+1),a=n.time[o]-n.time[r],l=a>0?Math.min(1,Math.max(0,(i-n.time[r])/a)):0,[c,u]=[n.position[r*e+t],n.position[o*e+t]];return c+l*(u-c)}function Jg(n,e,t){if(n.time.length===0||e.time.length===0)return null;let i=n.position.length/n.time.length;if(e.position.length/e.time.length!==i)return null;for(let s=0;s<n.time.length;++s){let r=n.time[s];for(let o=0;o<i/3;++o){let a=[0,1,2].map(c=>n.position[s*i+3*o+c]-qS(e,i,3*o+c,r)),l=Math.hypot(...a);if(!Number.isFinite(l)||l>t)return{time:r,body:o,distance:Number.isFinite(l)?l:1/0}}}return null}var YS="uplot",JS="u-hz",ZS="u-vt",KS="u-title",jS="u-wrap",QS="u-under",eM="u-over",tM="u-axis",zr="u-off",nM="u-select",iM="u-cursor-x",sM="u-cursor-y",rM="u-cursor-pt",oM="u-legend",aM="u-live",lM="u-inline",cM="u-series",uM="u-marker",Zg="u-label",hM="u-value",Ba="width",Va="height";var Kg="bottom",Ao="left",ef="right",xf="#000",jg=xf+"0",tf="mousemove",Qg="mousedown",nf="mouseup",e0="mouseenter",t0="mouseleave",n0="dblclick",dM="resize",fM="scroll",i0="change",pc="dppxchange",yf="--",Do=typeof window<"u",lf=Do?document:null,Co=Do?window:null,pM=Do?navigator:null,Dt,uc;function cf(){let n=devicePixelRatio;Dt!=n&&(Dt=n,uc&&hf(i0,uc,cf),uc=matchMedia(`(min-resolution: ${Dt-.001}dppx) and (max-resolution: ${Dt+.001}dppx)`),Gr(i0,uc,cf),Co.dispatchEvent(new CustomEvent(pc)))}function Si(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function uf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function en(n,e,t){n.style[e]=t+"px"}function os(n,e,t,i){let s=lf.createElement(n);return e!=null&&Si(s,e),t?.insertBefore(s,i),s}function Wi(n,e){return os("div",n,e)}var s0=new WeakMap;function Es(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=s0.get(n);r!=o&&(n.style.transform=r,s0.set(n,r),e<0||t<0||e>i||t>s?Si(n,zr):uf(n,zr))}var r0=new WeakMap;function o0(n,e,t){let i=e+t,s=r0.get(n);i!=s&&(r0.set(n,i),n.style.background=e,n.style.borderColor=t)}var a0=new WeakMap;function l0(n,e,t,i){let s=e+""+t,r=a0.get(n);s!=r&&(a0.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var vf={passive:!0},mM={...vf,capture:!0};function Gr(n,e,t,i){e.addEventListener(n,t,i?mM:vf)}function hf(n,e,t,i){e.removeEventListener(n,t,vf)}Do&&cf();function as(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Mi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function U0(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var k0=n=>n!=null,O0=n=>n!=null&&n>0,_c=U0(k0),gM=U0(O0);function _M(n,e,t,i=0,s=!1){let r=s?gM:_c,o=s?O0:k0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??$t,l??-$t]}function xc(n,e,t,i){let s=h0(n),r=h0(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?$s:B0,a=s==1?Mi:$i,l=r==1?$i:Mi,c=a(o(Ln(n))),u=l(o(Ln(e))),f=Ro(t,c),d=Ro(t,u);return t==10&&(c<0&&(f=Xt(f,-c)),u<0&&(d=Xt(d,-u))),i||t==2?(n=f*s,e=d*r):(n=H0(n,f),e=yc(e,d)),[n,e]}function bf(n,e,t,i){let s=xc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Sf=.1,c0={mode:3,pad:Sf},Ga={pad:0,soft:null,mode:0},xM={min:Ga,max:Ga};function mc(n,e,t,i){return vc(t)?u0(n,e,t):(Ga.pad=t,Ga.soft=i?0:null,Ga.mode=i?3:0,u0(n,e,xM))}function It(n,e){return n??e}function yM(n,e,t){for(e=It(e,0),t=It(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function u0(n,e,t){let i=t.min,s=t.max,r=It(i.pad,0),o=It(s.pad,0),a=It(i.hard,-$t),l=It(s.hard,$t),c=It(i.soft,$t),u=It(s.soft,-$t),f=It(i.mode,0),d=It(s.mode,0),p=e-n,m=$s(p),v=oi(Ln(n),Ln(e)),_=$s(v),g=Ln(_-m);(p<1e-24||g>10)&&(p=0,(n==0||e==0)&&(p=1e-24,f==2&&c!=$t&&(r=0),d==2&&u!=-$t&&(o=0)));let y=p||v||1e3,E=$s(y),M=Ro(10,Mi(E)),I=y*(p==0?n==0?.1:1:r),C=Xt(H0(n-I,M/10),24),b=n>=c&&(f==1||f==3&&C<=c||f==2&&C>=c)?c:$t,A=oi(a,C<b&&n>=b?b:ls(b,C)),H=y*(p==0?e==0?.1:1:o),F=Xt(yc(e+H,M/10),24),D=e<=u&&(d==1||d==3&&F>=u||d==2&&F<=u)?u:-$t,G=ls(l,F>D&&e<=D?D:oi(D,F));return A==G&&A==0&&(G=100),[A,G]}var vM=new Intl.NumberFormat(Do?pM.language:"en-US"),Mf=n=>vM.format(n),wi=Math,fc=wi.PI,Ln=wi.abs,Mi=wi.floor,In=wi.round,$i=wi.ceil,ls=wi.min,oi=wi.max,Ro=wi.pow,h0=wi.sign,$s=wi.log10,B0=wi.log2,bM=(n,e=1)=>wi.sinh(n)*e,sf=(n,e=1)=>wi.asinh(n/e),$t=1/0;function d0(n){return($s((n^n>>31)-(n>>31))|0)+1}function df(n,e,t){return ls(oi(n,e),t)}function V0(n){return typeof n=="function"}function wt(n){return V0(n)?n:()=>n}var SM=()=>{},z0=n=>n,G0=(n,e)=>e,MM=n=>null,f0=n=>!0,p0=(n,e)=>n==e,wM=/\.\d*?(?=9{6,}|0{6,})/gm,Hr=n=>{if($0(n)||xr.has(n))return n;let e=`${n}`,t=e.match(wM);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Hr(s)}e${r}`}return Xt(n,i)};function Br(n,e){return Hr(Xt(Hr(n/e))*e)}function yc(n,e){return Hr($i(Hr(n/e))*e)}function H0(n,e){return Hr(Mi(Hr(n/e))*e)}function Xt(n,e=0){if($0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return In(i)/t}var xr=new Map;function W0(n){return((""+n).split(".")[1]||"").length}function Wa(n,e,t,i){let s=[],r=i.map(W0);for(let o=e;o<t;o++){let a=Ln(o),l=Xt(Ro(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Xt(u,f);s.push(d),xr.set(d,f)}}return s}var Ha={},wf=[],Po=[null,null],_r=Array.isArray,$0=Number.isInteger,TM=n=>n===void 0;function m0(n){return typeof n=="string"}function vc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function AM(n){return n!=null&&typeof n=="object"}var EM=Object.getPrototypeOf(Uint8Array),X0="__proto__";function Io(n,e=vc){let t;if(_r(n)){let i=n.find(s=>s!=null);if(_r(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Io(n[s],e)}else t=n.slice()}else if(n instanceof EM)t=n.slice();else if(e(n)){t={};for(let i in n)i!=X0&&(t[i]=Io(n[i],e))}else t=n;return t}function An(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=X0&&(vc(n[s])?An(n[s],Io(i[s])):n[s]=Io(i[s]))}return n}var CM=0,RM=1,PM=2;function IM(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function LM(n,e){if(FM(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return UM(o[0])||(o=NM(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),d=e?e[o][c]:RM,p=[];for(let m=0;m<u.length;m++){let v=u[m],_=r.get(l[m]);v===null?d!=CM&&(f[_]=v,d==PM&&p.push(_)):f[_]=v}IM(f,p,s),i.push(f)}}return i}var DM=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function NM(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function FM(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function UM(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=oi(1,Mi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var q0=["January","February","March","April","May","June","July","August","September","October","November","December"],Y0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function J0(n){return n.slice(0,3)}var kM=Y0.map(J0),OM=q0.map(J0),BM={MMMM:q0,MMM:OM,WWWW:Y0,WWW:kM};function Oa(n){return(n<10?"0":"")+n}function VM(n){return(n<10?"00":n<100?"0":"")+n}var zM={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Oa(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Oa(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Oa(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Oa(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Oa(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>VM(n.getMilliseconds())};function Tf(n,e){e=e||BM;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?zM[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var GM=new Intl.DateTimeFormat().resolvedOptions().timeZone;function HM(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==GM?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Z0=n=>n%1==0,gc=[1,2,2.5,5],WM=Wa(10,-32,0,gc),K0=Wa(10,0,32,gc),$M=K0.filter(Z0),Vr=WM.concat(K0),Af=`
`,j0="{YYYY}",g0=Af+j0,Q0="{M}/{D}",za=Af+Q0,hc=za+"/{YY}",e_="{aa}",XM="{h}:{mm}",Eo=XM+e_,_0=Af+Eo,x0=":{ss}",Nt=null;function t_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Wa(10,0,3,gc).filter(Z0):Wa(10,-3,0,gc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,j0,Nt,Nt,Nt,Nt,Nt,Nt,1],[s*28,"{MMM}",g0,Nt,Nt,Nt,Nt,Nt,1],[s,Q0,g0,Nt,Nt,Nt,Nt,Nt,1],[i,"{h}"+e_,hc,Nt,za,Nt,Nt,Nt,1],[t,Eo,hc,Nt,za,Nt,Nt,Nt,1],[e,x0,hc+" "+Eo,Nt,za+" "+Eo,Nt,_0,Nt,1],[n,x0+".{fff}",hc+" "+Eo,Nt,za+" "+Eo,Nt,_0,Nt,1]];function u(f){return(d,p,m,v,_,g)=>{let y=[],E=_>=o,M=_>=r&&_<o,I=f(m),C=Xt(I*n,3),b=rf(I.getFullYear(),E?0:I.getMonth(),M||E?1:I.getDate()),A=Xt(b*n,3);if(M||E){let H=M?_/r:0,F=E?_/o:0,D=C==A?C:Xt(rf(b.getFullYear()+F,b.getMonth()+H,1)*n,3),G=new Date(In(D/n)),V=G.getFullYear(),N=G.getMonth();for(let W=0;D<=v;W++){let Z=rf(V+F*W,N+H*W,1),z=Z-f(Xt(Z*n,3));D=Xt((+Z+z)*n,3),D<=v&&y.push(D)}}else{let H=_>=s?s:_,F=Mi(m)-Mi(C),D=A+F+yc(C-A,H);y.push(D);let G=f(D),V=G.getHours()+G.getMinutes()/t+G.getSeconds()/i,N=_/i,W=d.axes[p]._space,Z=g/W;for(;D=Xt(D+_,n==1?0:3),!(D>v);)if(N>1){let z=Mi(Xt(V+N,6))%24,Q=f(D).getHours()-z;Q>1&&(Q=-1),D-=Q*i,V=(V+N)%24;let re=y[y.length-1];Xt((D-re)/_,3)*Z>=.7&&y.push(D)}else y.push(D)}return y}}return[l,c,u]}var[qM,YM,JM]=t_(1),[ZM,KM,jM]=t_(.001);Wa(2,-53,53,[1]);function y0(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function v0(n,e){return(t,i,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,f,d,p;return i.map(m=>{let v=n(m),_=v.getFullYear(),g=v.getMonth(),y=v.getDate(),E=v.getHours(),M=v.getMinutes(),I=v.getSeconds(),C=_!=l&&a[2]||g!=c&&a[3]||y!=u&&a[4]||E!=f&&a[5]||M!=d&&a[6]||I!=p&&a[7]||a[1];return l=_,c=g,u=y,f=E,d=M,p=I,C(v)})}}function QM(n,e){let t=Tf(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function rf(n,e,t){return new Date(n,e,t)}function b0(n,e){return e(n)}var ew="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function S0(n,e){return(t,i,s,r)=>r==null?yf:e(n(i))}function tw(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function nw(n,e){return n.series[e].fill(n,e)}var iw={show:!0,live:!0,isolate:!1,mount:SM,markers:{show:!0,width:2,stroke:tw,fill:nw,dash:"solid"},idx:null,idxs:null,values:[]};function sw(n,e){let t=n.cursor.points,i=Wi(),s=t.size(n,e);en(i,Ba,s),en(i,Va,s);let r=s/-2;en(i,"marginLeft",r),en(i,"marginTop",r);let o=t.width(n,e,s);return o&&en(i,"borderWidth",o),i}function rw(n,e){let t=n.series[e].points;return t._fill||t._stroke}function ow(n,e){let t=n.series[e].points;return t._stroke||t._fill}function aw(n,e){return n.series[e].points.size}var of=[0,0];function lw(n,e,t){return of[0]=e,of[1]=t,of}function dc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function af(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var cw={show:!0,x:!0,y:!0,lock:!1,move:lw,points:{one:!1,show:sw,size:aw,width:0,stroke:ow,fill:rw},bind:{mousedown:dc,mouseup:dc,click:dc,dblclick:dc,mousemove:af,mouseleave:af,mouseenter:af},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},n_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ef=An({},n_,{filter:G0}),i_=An({},Ef,{size:10}),s_=An({},n_,{show:!1}),Cf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',r_="bold "+Cf,o_=1.5,M0={show:!0,scale:"x",stroke:xf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:r_,side:2,grid:Ef,ticks:i_,border:s_,font:Cf,lineGap:o_,rotate:0},uw="Value",hw="Time",w0={show:!0,scale:"x",auto:!1,sorted:1,min:$t,max:-$t,idxs:[]};function dw(n,e,t,i,s){return e.map(r=>r==null?"":Mf(r))}function fw(n,e,t,i,s,r,o){let a=[],l=xr.get(s)||0;t=o?t:Xt(yc(t,s),l);for(let c=t;c<=i;c=Xt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ff(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?$s:B0,u=Mi(c(t));s=Ro(l,u),l==10&&(s=Vr[as(s,Vr)]);let f=t,d=s*l;l==10&&(d=Vr[as(d,Vr)]);do a.push(f),f=f+s,l==10&&!xr.has(f)&&(f=Xt(f,xr.get(s))),f>=d&&(s=f,d=s*l,l==10&&(d=Vr[as(d,Vr)]));while(f<=i);return a}function pw(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?ff(n,e,oi(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?ff(n,e,oi(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var a_=/./,mw=/[12357]/,gw=/[125]/,T0=/1/,pf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function _w(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?a_:l(7,o)-u>=c?mw:l(5,o)-u>=c?gw:T0;if(f==T0){let d=Ln(l(1,o)-u);if(d<c)return pf(e.slice().reverse(),a.distr,f,$i(c/d)).reverse()}return pf(e,a.distr,f,1)}function xw(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Ln(l(1,o)-l(2,o));return c<a?pf(e.slice().reverse(),3,a_,$i(a/c)).reverse():e}function yw(n,e,t,i){return i==null?yf:e==null?"":Mf(e)}var A0={show:!0,scale:"y",stroke:xf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:r_,side:3,grid:Ef,ticks:i_,border:s_,font:Cf,lineGap:o_,rotate:0};function vw(n,e){let t=3+(n||1)*2;return Xt(t*e,3)}function bw(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Ln(o-r),l=n.series[e],c=a/(l.points.space*Dt);return i[1]-i[0]<=c}var E0={scale:null,auto:!0,sorted:0,min:$t,max:-$t},l_=(n,e,t,i,s)=>s,C0={show:!0,auto:!0,sorted:0,gaps:l_,alpha:1,facets:[An({},E0,{scale:"x"}),An({},E0,{scale:"y"})]},R0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:l_,alpha:1,points:{show:bw,filter:null},values:null,min:$t,max:-$t,idxs:[],path:null,clip:null};function Sw(n,e,t,i,s){return t/10}var c_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Mw=An({},c_,{time:!1,ori:1}),P0={};function u_(n,e){let t=P0[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(P0[n]=t)),t}var Lo=1,mf=2;function Wr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,p=a.top,m=a.width,v=a.height,_=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,f,_,g,d,p,m,v,Sc,No,wc,d_,p_):t(s,l,c,u,f,g,_,p,d,v,m,Mc,Fo,If,f_,m_)}function Rf(n,e){let t=0,i=0,s=It(n.bands,wf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function ww(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Xs(n,e,t,i,s,r){return Wr(n,e,(o,a,l,c,u,f,d,p,m,v,_)=>{let g=o.pxRound,y=c.dir*(c.ori==0?1:-1),E=c.ori==0?No:Fo,M,I;y==1?(M=t,I=i):(M=i,I=t);let C=g(f(a[M],c,v,p)),b=g(d(l[M],u,_,m)),A=g(f(a[I],c,v,p)),H=g(d(r==1?u.max:u.min,u,_,m)),F=new Path2D(s);return E(F,A,H),E(F,C,H),E(F,C,b),F})}function bc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?wc:If,l=t;for(let f=0;f<n.length;f++){let d=n[f];if(d[1]>d[0]){let p=d[0]-l;p>0&&a(o,l,i,p,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Tw(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Pf(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let p=r(n[f]),m=d==f?p:r(n[d]),v=f-s;p=o<=0&&v>=0&&v<l?r(n[v]):p;let g=d+s;m=o>=0&&g>=0&&g<l?r(n[g]):m,m>=p&&a.push([p,m])}return a}function I0(n){return n==0?z0:n==1?In:e=>Br(e,n)}function h_(n){let e=n==0?Sc:Mc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=ls(c,a/2,l/2),u=ls(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Sc=(n,e,t)=>{n.moveTo(e,t)},Mc=(n,e,t)=>{n.moveTo(t,e)},No=(n,e,t)=>{n.lineTo(e,t)},Fo=(n,e,t)=>{n.lineTo(t,e)},wc=h_(0),If=h_(1),d_=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},f_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},p_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},m_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function g_(n){return(e,t,i,s,r)=>Wr(e,t,(o,a,l,c,u,f,d,p,m,v,_)=>{let{pxRound:g,points:y}=o,E,M;c.ori==0?(E=Sc,M=d_):(E=Mc,M=f_);let I=Xt(y.width*Dt,3),C=(y.size-y.width)/2*Dt,b=Xt(C*2,3),A=new Path2D,H=new Path2D,{left:F,top:D,width:G,height:V}=e.bbox;wc(H,F-b,D-b,G+b*2,V+b*2);let N=W=>{if(l[W]!=null){let Z=g(f(a[W],c,v,p)),z=g(d(l[W],u,_,m));E(A,Z+C,z),M(A,Z,z,C,0,fc*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:I>0?A:null,fill:A,clip:H,flags:Lo|mf}})}function __(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Aw=__(No),Ew=__(Fo);function x_(n){let e=It(n?.alignGaps,0);return(t,i,s,r)=>Wr(t,i,(o,a,l,c,u,f,d,p,m,v,_)=>{[s,r]=_c(l,s,r);let g=o.pxRound,y=V=>g(f(V,c,v,p)),E=V=>g(d(V,u,_,m)),M,I;c.ori==0?(M=No,I=Aw):(M=Fo,I=Ew);let C=c.dir*(c.ori==0?1:-1),b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Lo},A=b.stroke,H=!1;if(r-s>=v*4){let V=de=>t.posToVal(de,c.key,!0),N=null,W=null,Z,z,ue,K=y(a[C==1?s:r]),Q=y(a[s]),re=y(a[r]),fe=V(C==1?Q+1:re-1);for(let de=C==1?s:r;de>=s&&de<=r;de+=C){let ee=a[de],ye=(C==1?ee<fe:ee>fe)?K:y(ee),Ce=l[de];ye==K?Ce!=null?(z=Ce,N==null?(M(A,ye,E(z)),Z=N=W=z):z<N?N=z:z>W&&(W=z)):Ce===null&&(H=!0):(N!=null&&I(A,K,E(N),E(W),E(Z),E(z)),Ce!=null?(z=Ce,M(A,ye,E(z)),N=W=Z=z):(N=W=null,Ce===null&&(H=!0)),K=ye,fe=V(K+C))}N!=null&&N!=W&&ue!=K&&I(A,K,E(N),E(W),E(Z),E(z))}else for(let V=C==1?s:r;V>=s&&V<=r;V+=C){let N=l[V];N===null?H=!0:N!=null&&M(A,y(a[V]),E(N))}let[D,G]=Rf(t,i);if(o.fill!=null||D!=0){let V=b.fill=new Path2D(A),N=o.fillTo(t,i,o.min,o.max,D),W=E(N),Z=y(a[s]),z=y(a[r]);C==-1&&([z,Z]=[Z,z]),M(V,z,W),M(V,Z,W)}if(!o.spanGaps){let V=[];H&&V.push(...Pf(a,l,s,r,C,y,e)),b.gaps=V=o.gaps(t,i,s,r,V),b.clip=bc(V,c.ori,p,m,v,_)}return G!=0&&(b.band=G==2?[Xs(t,i,s,r,A,-1),Xs(t,i,s,r,A,1)]:Xs(t,i,s,r,A,G)),b})}function Cw(n){let e=It(n.align,1),t=It(n.ascDesc,!1),i=It(n.alignGaps,0),s=It(n.extend,!1);return(r,o,a,l)=>Wr(r,o,(c,u,f,d,p,m,v,_,g,y,E)=>{[a,l]=_c(f,a,l);let M=c.pxRound,{left:I,width:C}=r.bbox,b=Q=>M(m(Q,d,y,_)),A=Q=>M(v(Q,p,E,g)),H=d.ori==0?No:Fo,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Lo},D=F.stroke,G=d.dir*(d.ori==0?1:-1),V=A(f[G==1?a:l]),N=b(u[G==1?a:l]),W=N,Z=N;s&&e==-1&&(Z=I,H(D,Z,V)),H(D,N,V);for(let Q=G==1?a:l;Q>=a&&Q<=l;Q+=G){let re=f[Q];if(re==null)continue;let fe=b(u[Q]),de=A(re);e==1?H(D,fe,V):H(D,W,de),H(D,fe,de),V=de,W=fe}let z=W;s&&e==1&&(z=I+C,H(D,z,V));let[ue,K]=Rf(r,o);if(c.fill!=null||ue!=0){let Q=F.fill=new Path2D(D),re=c.fillTo(r,o,c.min,c.max,ue),fe=A(re);H(Q,z,fe),H(Q,Z,fe)}if(!c.spanGaps){let Q=[];Q.push(...Pf(u,f,a,l,G,b,i));let re=c.width*Dt/2,fe=t||e==1?re:-re,de=t||e==-1?-re:re;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=de}),F.gaps=Q=c.gaps(r,o,a,l,Q),F.clip=bc(Q,d.ori,_,g,y,E)}return K!=0&&(F.band=K==2?[Xs(r,o,a,l,D,-1),Xs(r,o,a,l,D,1)]:Xs(r,o,a,l,D,K)),F})}function L0(n,e,t,i,s,r,o=$t){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Ln(n[l]-n[a]);u<c&&(c=u,o=Ln(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Rw(n){n=n||Ha;let e=It(n.size,[.6,$t,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=wt(s),o=1-e[0],a=It(e[1],$t),l=It(e[2],1),c=It(n.disp,Ha),u=It(n.each,p=>{}),{fill:f,stroke:d}=c;return(p,m,v,_)=>Wr(p,m,(g,y,E,M,I,C,b,A,H,F,D)=>{let G=g.pxRound,V=t,N=i*Dt,W=a*Dt,Z=l*Dt,z,ue;M.ori==0?[z,ue]=r(p,m):[ue,z]=r(p,m);let K=M.dir*(M.ori==0?1:-1),Q=M.ori==0?wc:If,re=M.ori==0?u:(Pe,Je,ut,we,Wt,Ge,Ye)=>{u(Pe,Je,ut,Wt,we,Ye,Ge)},fe=It(p.bands,wf).find(Pe=>Pe.series[0]==m),de=fe!=null?fe.dir:0,ee=g.fillTo(p,m,g.min,g.max,de),ge=G(b(ee,I,D,H)),ye,Ce,Me,Xe=F,ct=G(g.width*Dt),We=!1,_t=null,ft=null,ot=null,nn=null;f!=null&&(ct==0||d!=null)&&(We=!0,_t=f.values(p,m,v,_),ft=new Map,new Set(_t).forEach(Pe=>{Pe!=null&&ft.set(Pe,new Path2D)}),ct>0&&(ot=d.values(p,m,v,_),nn=new Map,new Set(ot).forEach(Pe=>{Pe!=null&&nn.set(Pe,new Path2D)})));let{x0:qt,size:_n}=c;if(qt!=null&&_n!=null){V=1,y=qt.values(p,m,v,_),qt.unit==2&&(y=y.map(ut=>p.posToVal(A+ut*F,M.key,!0)));let Pe=_n.values(p,m,v,_);_n.unit==2?Ce=Pe[0]*F:Ce=C(Pe[0],M,F,A)-C(0,M,F,A),Xe=L0(y,E,C,M,F,A,Xe),Me=Xe-Ce+N}else Xe=L0(y,E,C,M,F,A,Xe),Me=Xe*o+N,Ce=Xe-Me;Me<1&&(Me=0),ct>=Ce/2&&(ct=0),Me<5&&(G=z0);let zt=Me>0,Fn=Xe-Me-(zt?ct:0);Ce=G(df(Fn,Z,W)),ye=(V==0?Ce/2:V==K?0:Ce)-V*K*((V==0?N/2:0)+(zt?ct/2:0));let At={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Rn=We?null:new Path2D,ln=null;if(fe!=null)ln=p.data[fe.series[1]];else{let{y0:Pe,y1:Je}=c;Pe!=null&&Je!=null&&(E=Je.values(p,m,v,_),ln=Pe.values(p,m,v,_))}let xn=z*Ce,k=ue*Ce;for(let Pe=K==1?v:_;Pe>=v&&Pe<=_;Pe+=K){let Je=E[Pe];if(Je==null)continue;if(ln!=null){let $=ln[Pe]??0;if(Je-$==0)continue;ge=b($,I,D,H)}let ut=M.distr!=2||c!=null?y[Pe]:Pe,we=C(ut,M,F,A),Wt=b(It(Je,ee),I,D,H),Ge=G(we-ye),Ye=G(oi(Wt,ge)),R=G(ls(Wt,ge)),S=Ye-R;if(Je!=null){let $=Je<0?k:xn,he=Je<0?xn:k;We?(ct>0&&ot[Pe]!=null&&Q(nn.get(ot[Pe]),Ge,R+Mi(ct/2),Ce,oi(0,S-ct),$,he),_t[Pe]!=null&&Q(ft.get(_t[Pe]),Ge,R+Mi(ct/2),Ce,oi(0,S-ct),$,he)):Q(Rn,Ge,R+Mi(ct/2),Ce,oi(0,S-ct),$,he),re(p,m,Pe,Ge-ct/2,R,Ce+ct,S)}}return ct>0?At.stroke=We?nn:Rn:We||(At._fill=g.width==0?g._fill:g._stroke??g._fill,At.width=0),At.fill=We?ft:Rn,At})}function Pw(n,e){let t=It(e?.alignGaps,0);return(i,s,r,o)=>Wr(i,s,(a,l,c,u,f,d,p,m,v,_,g)=>{[r,o]=_c(c,r,o);let y=a.pxRound,E=z=>y(d(z,u,_,m)),M=z=>y(p(z,f,g,v)),I,C,b;u.ori==0?(I=Sc,b=No,C=p_):(I=Mc,b=Fo,C=m_);let A=u.dir*(u.ori==0?1:-1),H=E(l[A==1?r:o]),F=H,D=[],G=[];for(let z=A==1?r:o;z>=r&&z<=o;z+=A)if(c[z]!=null){let K=l[z],Q=E(K);D.push(F=Q),G.push(M(c[z]))}let V={stroke:n(D,G,I,b,C,y),fill:null,clip:null,band:null,gaps:null,flags:Lo},N=V.stroke,[W,Z]=Rf(i,s);if(a.fill!=null||W!=0){let z=V.fill=new Path2D(N),ue=a.fillTo(i,s,a.min,a.max,W),K=M(ue);b(z,F,K),b(z,H,K)}if(!a.spanGaps){let z=[];z.push(...Pf(l,c,r,o,A,E,t)),V.gaps=z=a.gaps(i,s,r,o,z),V.clip=bc(z,u.ori,m,v,_,g)}return Z!=0&&(V.band=Z==2?[Xs(i,s,r,o,N,-1),Xs(i,s,r,o,N,1)]:Xs(i,s,r,o,N,Z)),V})}function Iw(n){return Pw(Lw,n)}function Lw(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],f[d]=n[d+1]-n[d],c[d]=u[d]/f[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(f[d-1]+f[d])/((2*f[d]+f[d-1])/c[d-1]+(f[d]+2*f[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+f[d]/3,e[d]+l[d]*f[d]/3,n[d+1]-f[d]/3,e[d+1]-l[d+1]*f[d]/3,n[d+1],e[d+1])}return a}var gf=new Set;function D0(){for(let n of gf)n.syncRect(!0)}Do&&(Gr(dM,Co,D0),Gr(fM,Co,D0,!0),Gr(pc,Co,()=>{En.pxRatio=Dt}));var Dw=x_(),Nw=g_();function N0(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>_f(r,o,e,t))}function Fw(n,e){return n.map((t,i)=>i==0?{}:An({},e,t))}function _f(n,e,t,i){return An({},e==0?t:i,n)}function y_(n,e,t){return e==null?Po:[e,t]}var Uw=y_;function kw(n,e,t){return e==null?Po:mc(e,t,Sf,!0)}function v_(n,e,t,i){return e==null?Po:xc(e,t,n.scales[i].log,!1)}var Ow=v_;function b_(n,e,t,i){return e==null?Po:bf(e,t,n.scales[i].log,!1)}var Bw=b_;function Vw(n,e,t,i,s){let r=oi(d0(n),d0(e)),o=e-n,a=as(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?xr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function F0(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=In((t=+s)*Dt))+"px"),[n,e,t]}function zw(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Xt(e[2]*Dt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function En(n,e,t){let i={mode:It(n.mode,1)},s=i.mode;function r(x,w,P,L){let B=w.valToPct(x);return L+P*(w.dir==-1?1-B:B)}function o(x,w,P,L){let B=w.valToPct(x);return L+P*(w.dir==-1?B:1-B)}function a(x,w,P,L){return w.ori==0?r(x,w,P,L):o(x,w,P,L)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Wi(YS);if(n.id!=null&&(c.id=n.id),Si(c,n.class),n.title){let x=Wi(KS,c);x.textContent=n.title}let u=os("canvas"),f=i.ctx=u.getContext("2d"),d=Wi(jS,c);Gr("click",d,x=>{x.target===m&&(Kt!=go||sn!=_o)&&Wn.click(i,x)},!0);let p=i.under=Wi(QS,d);d.appendChild(u);let m=i.over=Wi(eM,d);n=Io(n);let v=+It(n.pxAlign,1),_=I0(v);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let g=n.ms||.001,y=i.series=s==1?N0(n.series||[],w0,R0,!1):Fw(n.series||[null],C0),E=i.axes=N0(n.axes||[],M0,A0,!0),M=i.scales={},I=i.bands=n.bands||[];I.forEach(x=>{x.fill=wt(x.fill||null),x.dir=It(x.dir,-1)});let C=s==2?y[1].facets[0].scale:y[0].scale,b={axes:Gs,series:vt},A=(n.drawOrder||["axes","series"]).map(x=>b[x]);function H(x){let w=x.distr==3?P=>$s(P>0?P:x.clamp(i,P,x.min,x.max,x.key)):x.distr==4?P=>sf(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let L=w(P),{_min:B,_max:J}=x,le=J-B;return(L-B)/le}}function F(x){let w=M[x];if(w==null){let P=(n.scales||Ha)[x]||Ha;if(P.from!=null){F(P.from);let L=An({},M[P.from],P,{key:x});L.valToPct=H(L),M[x]=L}else{w=M[x]=An({},x==C?c_:Mw,P),w.key=x;let L=w.time,B=w.range,J=_r(B);if((x!=C||s==2&&!L)&&(J&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?c0:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?c0:{mode:1,hard:B[1],soft:B[1]}},J=!1),!J&&vc(B))){let le=B;B=(pe,be,Fe)=>be==null?Po:mc(be,Fe,le)}w.range=wt(B||(L?Uw:x==C?w.distr==3?Ow:w.distr==4?Bw:y_:w.distr==3?v_:w.distr==4?b_:kw)),w.auto=wt(J?!1:w.auto),w.clamp=wt(w.clamp||Sw),w._min=w._max=null,w.valToPct=H(w)}}}F("x"),F("y"),s==1&&y.forEach(x=>{F(x.scale)}),E.forEach(x=>{F(x.scale)});for(let x in n.scales)F(x);let D=M[C],G=D.distr,V,N;D.ori==0?(Si(c,JS),V=r,N=o):(Si(c,ZS),V=o,N=r);let W={};for(let x in M){let w=M[x];(w.min!=null||w.max!=null)&&(W[x]={min:w.min,max:w.max},w.min=w.max=null)}let Z=n.tzDate||(x=>new Date(In(x/g))),z=n.fmtDate||Tf,ue=g==1?JM(Z):jM(Z),K=v0(Z,y0(g==1?YM:KM,z)),Q=S0(Z,b0(ew,z)),re=[],fe=i.legend=An({},iw,n.legend),de=i.cursor=An({},cw,{drag:{y:s==2}},n.cursor),ee=fe.show,ge=de.show,ye=fe.markers;fe.idxs=re,ye.width=wt(ye.width),ye.dash=wt(ye.dash),ye.stroke=wt(ye.stroke),ye.fill=wt(ye.fill);let Ce,Me,Xe,ct=[],We=[],_t,ft=!1,ot={};if(fe.live){let x=y[1]?y[1].values:null;ft=x!=null,_t=ft?x(i,1,0):{_:0};for(let w in _t)ot[w]=yf}if(ee)if(Ce=os("table",oM,c),Xe=os("tbody",null,Ce),fe.mount(i,Ce),ft){Me=os("thead",null,Ce,Xe);let x=os("tr",null,Me);os("th",null,x);for(var nn in _t)os("th",Zg,x).textContent=nn}else Si(Ce,lM),fe.live&&Si(Ce,aM);let qt={show:!0},_n={show:!1};function zt(x,w){if(w==0&&(ft||!fe.live||s==2))return Po;let P=[],L=os("tr",cM,Xe,Xe.childNodes[w]);Si(L,x.class),x.show||Si(L,zr);let B=os("th",null,L);if(ye.show){let pe=Wi(uM,B);if(w>0){let be=ye.width(i,w);be&&(pe.style.border=be+"px "+ye.dash(i,w)+" "+ye.stroke(i,w)),pe.style.background=ye.fill(i,w)}}let J=Wi(Zg,B);x.label instanceof HTMLElement?J.appendChild(x.label):J.textContent=x.label,w>0&&(ye.show||(J.style.color=x.width>0?ye.stroke(i,w):ye.fill(i,w)),At("click",B,pe=>{if(de._lock)return;et(pe);let be=y.indexOf(x);if((pe.ctrlKey||pe.metaKey)!=fe.isolate){let Fe=y.some((Ue,Oe)=>Oe>0&&Oe!=be&&Ue.show);y.forEach((Ue,Oe)=>{Oe>0&&vs(Oe,Fe?Oe==be?qt:_n:qt,!0,Sn.setSeries)})}else vs(be,{show:!x.show},!0,Sn.setSeries)},!1),tt&&At(e0,B,pe=>{de._lock||(et(pe),vs(y.indexOf(x),yo,!0,Sn.setSeries))},!1));for(var le in _t){let pe=os("td",hM,L);pe.textContent="--",P.push(pe)}return[L,P]}let Fn=new Map;function At(x,w,P,L=!0){let B=Fn.get(w)||{},J=de.bind[x](i,w,P,L);J&&(Gr(x,w,B[x]=J),Fn.set(w,B))}function Rn(x,w,P){let L=Fn.get(w)||{};for(let B in L)(x==null||B==x)&&(hf(B,w,L[B]),delete L[B]);x==null&&Fn.delete(w)}let ln=0,xn=0,k=0,Pe=0,Je=0,ut=0,we=Je,Wt=ut,Ge=k,Ye=Pe,R=0,S=0,$=0,he=0;i.bbox={};let ae=!1,xe=!1,ve=!1,ne=!1,se=!1,me=!1;function U(x,w,P){(P||x!=i.width||w!=i.height)&&oe(x,w),pt(!1),ve=!0,xe=!0,qn()}function oe(x,w){i.width=ln=k=x,i.height=xn=Pe=w,Je=ut=0,Se(),$e();let P=i.bbox;R=P.left=Br(Je*Dt,.5),S=P.top=Br(ut*Dt,.5),$=P.width=Br(k*Dt,.5),he=P.height=Br(Pe*Dt,.5)}let ie=3;function Te(){let x=!1,w=0;for(;!x;){w++;let P=fo(w),L=ys(w);x=w==ie||P&&L,x||(oe(i.width,i.height),xe=!0)}}function _e({width:x,height:w}){U(x,w)}i.setSize=_e;function Se(){let x=!1,w=!1,P=!1,L=!1;E.forEach((B,J)=>{if(B.show&&B._show){let{side:le,_size:pe}=B,be=le%2,Fe=B.label!=null?B.labelSize:0,Ue=pe+Fe;Ue>0&&(be?(k-=Ue,le==3?(Je+=Ue,L=!0):P=!0):(Pe-=Ue,le==0?(ut+=Ue,x=!0):w=!0))}}),_s[0]=x,_s[1]=P,_s[2]=w,_s[3]=L,k-=Qi[1]+Qi[3],Je+=Qi[3],Pe-=Qi[2]+Qi[0],ut+=Qi[0]}function $e(){let x=Je+k,w=ut+Pe,P=Je,L=ut;function B(J,le){switch(J){case 1:return x+=le,x-le;case 2:return w+=le,w-le;case 3:return P-=le,P+le;case 0:return L-=le,L+le}}E.forEach((J,le)=>{if(J.show&&J._show){let pe=J.side;J._pos=B(pe,J._size),J.label!=null&&(J._lpos=B(pe,J.labelSize))}})}if(de.dataIdx==null){let x=de.hover,w=x.skip=new Set(x.skip??[]);w.add(void 0);let P=x.prox=wt(x.prox),L=x.bias??=0;de.dataIdx=(B,J,le,pe)=>{if(J==0)return le;let be=le,Fe=P(B,J,le,pe)??$t,Ue=Fe>=0&&Fe<$t,Oe=D.ori==0?k:Pe,at=de.left,Lt=e[0],Pt=e[J];if(w.has(Pt[le])){be=null;let St=null,Qe=null,qe;if(L==0||L==-1)for(qe=le;St==null&&qe-- >0;)w.has(Pt[qe])||(St=qe);if(L==0||L==1)for(qe=le;Qe==null&&qe++<Pt.length;)w.has(Pt[qe])||(Qe=qe);if(St!=null||Qe!=null)if(Ue){let Qt=St==null?-1/0:V(Lt[St],D,Oe,0),hn=Qe==null?1/0:V(Lt[Qe],D,Oe,0),Bn=at-Qt,Gt=hn-at;Bn<=Gt?Bn<=Fe&&(be=St):Gt<=Fe&&(be=Qe)}else be=Qe==null?St:St==null?Qe:le-St<=Qe-le?St:Qe}else Ue&&Ln(at-V(Lt[le],D,Oe,0))>Fe&&(be=null);return be}}let et=x=>{de.event=x};de.idxs=re,de._lock=!1;let ce=de.points;ce.show=wt(ce.show),ce.size=wt(ce.size),ce.stroke=wt(ce.stroke),ce.width=wt(ce.width),ce.fill=wt(ce.fill);let Be=i.focus=An({},n.focus||{alpha:.3},de.focus),tt=Be.prox>=0,Re=tt&&ce.one,ht=[],Zt=[],Qn=[];function Sa(x,w){let P=ce.show(i,w);if(P instanceof HTMLElement)return Si(P,rM),Si(P,x.class),Es(P,-10,-10,k,Pe),m.insertBefore(P,ht[w]),P}function co(x,w){if(s==1||w>0){let P=s==1&&M[x.scale].time,L=x.value;x.value=P?m0(L)?S0(Z,b0(L,z)):L||Q:L||yw,x.label=x.label||(P?hw:uw)}if(Re||w>0){x.width=x.width==null?1:x.width,x.paths=x.paths||Dw||MM,x.fillTo=wt(x.fillTo||ww),x.pxAlign=+It(x.pxAlign,v),x.pxRound=I0(x.pxAlign),x.stroke=wt(x.stroke||null),x.fill=wt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=vw(oi(1,x.width),1),L=x.points=An({},{size:P,width:oi(1,P*.2),stroke:x.stroke,space:P*2,paths:Nw,_stroke:null,_fill:null},x.points);L.show=wt(L.show),L.filter=wt(L.filter),L.fill=wt(L.fill),L.stroke=wt(L.stroke),L.paths=wt(L.paths),L.pxAlign=x.pxAlign}if(ee){let P=zt(x,w);ct.splice(w,0,P[0]),We.splice(w,0,P[1]),fe.values.push(null)}if(ge){re.splice(w,0,null);let P=null;Re?w==0&&(P=Sa(x,w)):w>0&&(P=Sa(x,w)),ht.splice(w,0,P),Zt.splice(w,0,0),Qn.splice(w,0,0)}On("addSeries",w)}function Td(x,w){w=w??y.length,x=s==1?_f(x,w,w0,R0):_f(x,w,{},C0),y.splice(w,0,x),co(y[w],w)}i.addSeries=Td;function Gl(x){if(y.splice(x,1),ee){fe.values.splice(x,1),We.splice(x,1);let w=ct.splice(x,1)[0];Rn(null,w.firstChild),w.remove()}ge&&(re.splice(x,1),ht.splice(x,1)[0].remove(),Zt.splice(x,1),Qn.splice(x,1)),On("delSeries",x)}i.delSeries=Gl;let _s=[!1,!1,!1,!1];function Bs(x,w){if(x._show=x.show,x.show){let P=x.side%2,L=M[x.scale];L==null&&(x.scale=P?y[1].scale:C,L=M[x.scale]);let B=L.time;x.size=wt(x.size),x.space=wt(x.space),x.rotate=wt(x.rotate),_r(x.incrs)&&x.incrs.forEach(le=>{!xr.has(le)&&xr.set(le,W0(le))}),x.incrs=wt(x.incrs||(L.distr==2?$M:B?g==1?qM:ZM:Vr)),x.splits=wt(x.splits||(B&&L.distr==1?ue:L.distr==3?ff:L.distr==4?pw:fw)),x.stroke=wt(x.stroke),x.grid.stroke=wt(x.grid.stroke),x.ticks.stroke=wt(x.ticks.stroke),x.border.stroke=wt(x.border.stroke);let J=x.values;x.values=_r(J)&&!_r(J[0])?wt(J):B?_r(J)?v0(Z,y0(J,z)):m0(J)?QM(Z,J):J||K:J||dw,x.filter=wt(x.filter||(L.distr>=3&&L.log==10?_w:L.distr==3&&L.log==2?xw:G0)),x.font=F0(x.font),x.labelFont=F0(x.labelFont),x._size=x.size(i,null,w,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(_s[w]=!0,x._el=Wi(tM,d))}}function Vs(x,w,P,L){let[B,J,le,pe]=P,be=w%2,Fe=0;return be==0&&(pe||J)&&(Fe=w==0&&!B||w==2&&!le?In(M0.size/3):0),be==1&&(B||le)&&(Fe=w==1&&!J||w==3&&!pe?In(A0.size/2):0),Fe}let Ma=i.padding=(n.padding||[Vs,Vs,Vs,Vs]).map(x=>wt(It(x,Vs))),Qi=i._padding=Ma.map((x,w)=>x(i,w,_s,0)),cn,pn=null,mn=null,xs=s==1?y[0].idxs:null,_i=null,lr=!1;function wa(x,w){if(e=x??[],i.data=i._data=e,s==2){cn=0;for(let P=1;P<y.length;P++)cn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),_i=e[0],cn=_i.length;let P=e;if(G==2){P=e.slice();let L=P[0]=Array(cn);for(let B=0;B<cn;B++)L[B]=B}i._data=e=P}if(pt(!0),On("setData"),G==2&&(ve=!0),w!==!1){let P=D;P.auto(i,lr)?Ta():hr(C,P.min,P.max),ne=ne||de.left>=0,me=!0,qn()}}i.setData=wa;function Ta(){lr=!0;let x,w;s==1&&(cn>0?(pn=xs[0]=0,mn=xs[1]=cn-1,x=e[0][pn],w=e[0][mn],G==2?(x=pn,w=mn):x==w&&(G==3?[x,w]=xc(x,x,D.log,!1):G==4?[x,w]=bf(x,x,D.log,!1):D.time?w=x+In(86400/g):[x,w]=mc(x,w,Sf,!0))):(pn=xs[0]=x=null,mn=xs[1]=w=null)),hr(C,x,w)}let uo,cr,ho,T,O,j,q,Y,Ae,Ie;function Ee(x,w,P,L,B,J){x??=jg,P??=wf,L??="butt",B??=jg,J??="round",x!=uo&&(f.strokeStyle=uo=x),B!=cr&&(f.fillStyle=cr=B),w!=ho&&(f.lineWidth=ho=w),J!=O&&(f.lineJoin=O=J),L!=j&&(f.lineCap=j=L),P!=T&&f.setLineDash(T=P)}function Le(x,w,P,L){w!=cr&&(f.fillStyle=cr=w),x!=q&&(f.font=q=x),P!=Y&&(f.textAlign=Y=P),L!=Ae&&(f.textBaseline=Ae=L)}function ze(x,w,P,L,B=0){if(L.length>0&&x.auto(i,lr)&&(w==null||w.min==null)){let J=It(pn,0),le=It(mn,L.length-1),pe=P.min==null?_M(L,J,le,B,x.distr==3):[P.min,P.max];x.min=ls(x.min,P.min=pe[0]),x.max=oi(x.max,P.max=pe[1])}}let it={min:null,max:null};function yt(){for(let L in M){let B=M[L];W[L]==null&&(B.min==null||W[C]!=null&&B.auto(i,lr))&&(W[L]=it)}for(let L in M){let B=M[L];W[L]==null&&B.from!=null&&W[B.from]!=null&&(W[L]=it)}W[C]!=null&&pt(!0);let x={};for(let L in W){let B=W[L];if(B!=null){let J=x[L]=Io(M[L],AM);if(B.min!=null)An(J,B);else if(L!=C||s==2)if(cn==0&&J.from==null){let le=J.range(i,null,null,L);J.min=le[0],J.max=le[1]}else J.min=$t,J.max=-$t}}if(cn>0){y.forEach((L,B)=>{if(s==1){let J=L.scale,le=W[J];if(le==null)return;let pe=x[J];if(B==0){let be=pe.range(i,pe.min,pe.max,J);pe.min=be[0],pe.max=be[1],pn=as(pe.min,e[0]),mn=as(pe.max,e[0]),mn-pn>1&&(e[0][pn]<pe.min&&pn++,e[0][mn]>pe.max&&mn--),L.min=_i[pn],L.max=_i[mn]}else L.show&&L.auto&&ze(pe,le,L,e[B],L.sorted);L.idxs[0]=pn,L.idxs[1]=mn}else if(B>0&&L.show&&L.auto){let[J,le]=L.facets,pe=J.scale,be=le.scale,[Fe,Ue]=e[B],Oe=x[pe],at=x[be];Oe!=null&&ze(Oe,W[pe],J,Fe,J.sorted),at!=null&&ze(at,W[be],le,Ue,le.sorted),L.min=le.min,L.max=le.max}});for(let L in x){let B=x[L],J=W[L];if(B.from==null&&(J==null||J.min==null)){let le=B.range(i,B.min==$t?null:B.min,B.max==-$t?null:B.max,L);B.min=le[0],B.max=le[1]}}}for(let L in x){let B=x[L];if(B.from!=null){let J=x[B.from];if(J.min==null)B.min=B.max=null;else{let le=B.range(i,J.min,J.max,L);B.min=le[0],B.max=le[1]}}}let w={},P=!1;for(let L in x){let B=x[L],J=M[L];if(J.min!=B.min||J.max!=B.max){J.min=B.min,J.max=B.max;let le=J.distr;J._min=le==3?$s(J.min):le==4?sf(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?$s(J.max):le==4?sf(J.max,J.asinh):le==100?J.fwd(J.max):J.max,w[L]=P=!0}}if(P){y.forEach((L,B)=>{s==2?B>0&&w.y&&(L._paths=null):w[L.scale]&&(L._paths=null)});for(let L in w)ve=!0,On("setScale",L);ge&&de.left>=0&&(ne=me=!0)}for(let L in W)W[L]=null}function Ve(x){let w=df(pn-1,0,cn-1),P=df(mn+1,0,cn-1);for(;x[w]==null&&w>0;)w--;for(;x[P]==null&&P<cn-1;)P++;return[w,P]}function vt(){if(cn>0){let x=y.some(w=>w._focus)&&Ie!=Be.alpha;x&&(f.globalAlpha=Ie=Be.alpha),y.forEach((w,P)=>{if(P>0&&w.show&&(rn(P,!1),rn(P,!0),w._paths==null)){let L=Ie;Ie!=w.alpha&&(f.globalAlpha=Ie=w.alpha);let B=s==2?[0,e[P][0].length-1]:Ve(e[P]);w._paths=w.paths(i,P,B[0],B[1]),Ie!=L&&(f.globalAlpha=Ie=L)}}),y.forEach((w,P)=>{if(P>0&&w.show){let L=Ie;Ie!=w.alpha&&(f.globalAlpha=Ie=w.alpha),w._paths!=null&&Ut(P,!1);{let B=w._paths!=null?w._paths.gaps:null,J=w.points.show(i,P,pn,mn,B),le=w.points.filter(i,P,J,B);(J||le)&&(w.points._paths=w.points.paths(i,P,pn,mn,le),Ut(P,!0))}Ie!=L&&(f.globalAlpha=Ie=L),On("drawSeries",P)}}),x&&(f.globalAlpha=Ie=1)}}function rn(x,w){let P=w?y[x].points:y[x];P._stroke=P.stroke(i,x),P._fill=P.fill(i,x)}function Ut(x,w){let P=w?y[x].points:y[x],{stroke:L,fill:B,clip:J,flags:le,_stroke:pe=P._stroke,_fill:be=P._fill,_width:Fe=P.width}=P._paths;Fe=Xt(Fe*Dt,3);let Ue=null,Oe=Fe%2/2;w&&be==null&&(be=Fe>0?"#fff":pe);let at=P.pxAlign==1&&Oe>0;if(at&&f.translate(Oe,Oe),!w){let Lt=R-Fe/2,Pt=S-Fe/2,St=$+Fe,Qe=he+Fe;Ue=new Path2D,Ue.rect(Lt,Pt,St,Qe)}w?ke(pe,Fe,P.dash,P.cap,be,L,B,le,J):kt(x,pe,Fe,P.dash,P.cap,be,L,B,le,Ue,J),at&&f.translate(-Oe,-Oe)}function kt(x,w,P,L,B,J,le,pe,be,Fe,Ue){let Oe=!1;be!=0&&I.forEach((at,Lt)=>{if(at.series[0]==x){let Pt=y[at.series[1]],St=e[at.series[1]],Qe=(Pt._paths||Ha).band;_r(Qe)&&(Qe=at.dir==1?Qe[0]:Qe[1]);let qe,Qt=null;Pt.show&&Qe&&yM(St,pn,mn)?(Qt=at.fill(i,Lt)||J,qe=Pt._paths.clip):Qe=null,ke(w,P,L,B,Qt,le,pe,be,Fe,Ue,qe,Qe),Oe=!0}}),Oe||ke(w,P,L,B,J,le,pe,be,Fe,Ue)}let Pn=Lo|mf;function ke(x,w,P,L,B,J,le,pe,be,Fe,Ue,Oe){Ee(x,w,P,L,B),(be||Fe||Oe)&&(f.save(),be&&f.clip(be),Fe&&f.clip(Fe)),Oe?(pe&Pn)==Pn?(f.clip(Oe),Ue&&f.clip(Ue),Mt(B,le),yn(x,J,w)):pe&mf?(Mt(B,le),f.clip(Oe),yn(x,J,w)):pe&Lo&&(f.save(),f.clip(Oe),Ue&&f.clip(Ue),Mt(B,le),f.restore(),yn(x,J,w)):(Mt(B,le),yn(x,J,w)),(be||Fe||Oe)&&f.restore()}function yn(x,w,P){P>0&&(w instanceof Map?w.forEach((L,B)=>{f.strokeStyle=uo=B,f.stroke(L)}):w!=null&&x&&f.stroke(w))}function Mt(x,w){w instanceof Map?w.forEach((P,L)=>{f.fillStyle=cr=L,f.fill(P)}):w!=null&&x&&f.fill(w)}function zs(x,w,P,L){let B=E[x],J;if(L<=0)J=[0,0];else{let le=B._space=B.space(i,x,w,P,L),pe=B._incrs=B.incrs(i,x,w,P,L,le);J=Vw(w,P,pe,L,le)}return B._found=J}function vn(x,w,P,L,B,J,le,pe,be,Fe){let Ue=le%2/2;v==1&&f.translate(Ue,Ue),Ee(pe,le,be,Fe,pe),f.beginPath();let Oe,at,Lt,Pt,St=B+(L==0||L==3?-J:J);P==0?(at=B,Pt=St):(Oe=B,Lt=St);for(let Qe=0;Qe<x.length;Qe++)w[Qe]!=null&&(P==0?Oe=Lt=x[Qe]:at=Pt=x[Qe],f.moveTo(Oe,at),f.lineTo(Lt,Pt));f.stroke(),v==1&&f.translate(-Ue,-Ue)}function fo(x){let w=!0;return E.forEach((P,L)=>{if(!P.show)return;let B=M[P.scale];if(B.min==null){P._show&&(w=!1,P._show=!1,pt(!1));return}else P._show||(w=!1,P._show=!0,pt(!1));let J=P.side,le=J%2,{min:pe,max:be}=B,[Fe,Ue]=zs(L,pe,be,le==0?k:Pe);if(Ue==0)return;let Oe=B.distr==2,at=P._splits=P.splits(i,L,pe,be,Fe,Ue,Oe),Lt=B.distr==2?at.map(qe=>_i[qe]):at,Pt=B.distr==2?_i[at[1]]-_i[at[0]]:Fe,St=P._values=P.values(i,P.filter(i,Lt,L,Ue,Pt),L,Ue,Pt);P._rotate=J==2?P.rotate(i,St,L,Ue):0;let Qe=P._size;P._size=$i(P.size(i,St,L,x)),Qe!=null&&P._size!=Qe&&(w=!1)}),w}function ys(x){let w=!0;return Ma.forEach((P,L)=>{let B=P(i,L,_s,x);B!=Qi[L]&&(w=!1),Qi[L]=B}),w}function Gs(){for(let x=0;x<E.length;x++){let w=E[x];if(!w.show||!w._show)continue;let P=w.side,L=P%2,B,J,le=w.stroke(i,x),pe=P==0||P==3?-1:1,[be,Fe]=w._found;if(w.label!=null){let ni=w.labelGap*pe,vi=In((w._lpos+ni)*Dt);Le(w.labelFont[0],le,"center",P==2?"top":Kg),f.save(),L==1?(B=J=0,f.translate(vi,In(S+he/2)),f.rotate((P==3?-fc:fc)/2)):(B=In(R+$/2),J=vi);let Ur=V0(w.label)?w.label(i,x,be,Fe):w.label;f.fillText(Ur,B,J),f.restore()}if(Fe==0)continue;let Ue=M[w.scale],Oe=L==0?$:he,at=L==0?R:S,Lt=w._splits,Pt=Ue.distr==2?Lt.map(ni=>_i[ni]):Lt,St=Ue.distr==2?_i[Lt[1]]-_i[Lt[0]]:be,Qe=w.ticks,qe=w.border,Qt=Qe.show?Qe.size:0,hn=In(Qt*Dt),Bn=In((w.alignTo==2?w._size-Qt-w.gap:w.gap)*Dt),Gt=w._rotate*-fc/180,dn=_(w._pos*Dt),xi=(hn+Bn)*pe,ti=dn+xi;J=L==0?ti:0,B=L==1?ti:0;let Vi=w.font[0],es=w.align==1?Ao:w.align==2?ef:Gt>0?Ao:Gt<0?ef:L==0?"center":P==3?ef:Ao,Ss=Gt||L==1?"middle":P==2?"top":Kg;Le(Vi,le,es,Ss);let yi=w.font[1]*w.lineGap,zi=Lt.map(ni=>_(a(ni,Ue,Oe,at))),ts=w._values;for(let ni=0;ni<ts.length;ni++){let vi=ts[ni];if(vi!=null){L==0?B=zi[ni]:J=zi[ni],vi=""+vi;let Ur=vi.indexOf(`
`)==-1?[vi]:vi.split(/\n/gm);for(let ii=0;ii<Ur.length;ii++){let Km=Ur[ii];Gt?(f.save(),f.translate(B,J+ii*yi),f.rotate(Gt),f.fillText(Km,0,0),f.restore()):f.fillText(Km,B,J+ii*yi)}}}Qe.show&&vn(zi,Qe.filter(i,Pt,x,Fe,St),L,P,dn,hn,Xt(Qe.width*Dt,3),Qe.stroke(i,x),Qe.dash,Qe.cap);let Ms=w.grid;Ms.show&&vn(zi,Ms.filter(i,Pt,x,Fe,St),L,L==0?2:1,L==0?S:R,L==0?he:$,Xt(Ms.width*Dt,3),Ms.stroke(i,x),Ms.dash,Ms.cap),qe.show&&vn([dn],[1],L==0?1:0,L==0?1:2,L==1?S:R,L==1?he:$,Xt(qe.width*Dt,3),qe.stroke(i,x),qe.dash,qe.cap)}On("drawAxes")}function pt(x){y.forEach((w,P)=>{P>0&&(w._paths=null,x&&(s==1?(w.min=null,w.max=null):w.facets.forEach(L=>{L.min=null,L.max=null})))})}let un=!1,ei=!1,Ot=[];function bn(){ei=!1;for(let x=0;x<Ot.length;x++)On(...Ot[x]);Ot.length=0}function qn(){un||(DM(Dm),un=!0)}function Hl(x,w=!1){un=!0,ei=w,x(i),Dm(),w&&Ot.length>0&&queueMicrotask(bn)}i.batch=Hl;function Dm(){if(ae&&(yt(),ae=!1),ve&&(Te(),ve=!1),xe){if(en(p,Ao,Je),en(p,"top",ut),en(p,Ba,k),en(p,Va,Pe),en(m,Ao,Je),en(m,"top",ut),en(m,Ba,k),en(m,Va,Pe),en(d,Ba,ln),en(d,Va,xn),u.width=In(ln*Dt),u.height=In(xn*Dt),E.forEach(({_el:x,_show:w,_size:P,_pos:L,side:B})=>{if(x!=null)if(w){let J=B===3||B===0?P:0,le=B%2==1;en(x,le?"left":"top",L-J),en(x,le?"width":"height",P),en(x,le?"top":"left",le?ut:Je),en(x,le?"height":"width",le?Pe:k),uf(x,zr)}else Si(x,zr)}),uo=cr=ho=O=j=q=Y=Ae=T=null,Ie=1,Ca(!0),Je!=we||ut!=Wt||k!=Ge||Pe!=Ye){pt(!1);let x=k/Ge,w=Pe/Ye;if(ge&&!ne&&de.left>=0){de.left*=x,de.top*=w,po&&Es(po,In(de.left),0,k,Pe),mo&&Es(mo,0,In(de.top),k,Pe);for(let P=0;P<ht.length;P++){let L=ht[P];L!=null&&(Zt[P]*=x,Qn[P]*=w,Es(L,$i(Zt[P]),$i(Qn[P]),k,Pe))}}if(jt.show&&!se&&jt.left>=0&&jt.width>0){jt.left*=x,jt.width*=x,jt.top*=w,jt.height*=w;for(let P in Id)en(xo,P,jt[P])}we=Je,Wt=ut,Ge=k,Ye=Pe}On("setSize"),xe=!1}ln>0&&xn>0&&(f.clearRect(0,0,u.width,u.height),On("drawClear"),A.forEach(x=>x()),On("draw")),jt.show&&se&&(Wl(jt),se=!1),ge&&ne&&(Fr(null,!0,!1),ne=!1),fe.show&&fe.live&&me&&(Rd(),me=!1),l||(l=!0,i.status=1,On("ready")),lr=!1,un=!1}i.redraw=(x,w)=>{ve=w||!1,x!==!1?hr(C,D.min,D.max):qn()};function Ad(x,w){let P=M[x];if(P.from==null){if(cn==0){let L=P.range(i,w.min,w.max,x);w.min=L[0],w.max=L[1]}if(w.min>w.max){let L=w.min;w.min=w.max,w.max=L}if(cn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;x==C&&P.distr==2&&cn>0&&(w.min=as(w.min,e[0]),w.max=as(w.max,e[0]),w.min==w.max&&w.max++),W[x]=w,ae=!0,qn()}}i.setScale=Ad;let Ed,Cd,po,mo,Nm,Fm,go,_o,Um,km,Kt,sn,ur=!1,Wn=de.drag,Un=Wn.x,kn=Wn.y;ge&&(de.x&&(Ed=Wi(iM,m)),de.y&&(Cd=Wi(sM,m)),D.ori==0?(po=Ed,mo=Cd):(po=Cd,mo=Ed),Kt=de.left,sn=de.top);let jt=i.select=An({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),xo=jt.show?Wi(nM,jt.over?m:p):null;function Wl(x,w){if(jt.show){for(let P in x)jt[P]=x[P],P in Id&&en(xo,P,x[P]);w!==!1&&On("setSelect")}}i.setSelect=Wl;function hS(x){if(y[x].show)ee&&uf(ct[x],zr);else if(ee&&Si(ct[x],zr),ge){let P=Re?ht[0]:ht[x];P!=null&&Es(P,-10,-10,k,Pe)}}function hr(x,w,P){Ad(x,{min:w,max:P})}function vs(x,w,P,L){w.focus!=null&&gS(x),w.show!=null&&y.forEach((B,J)=>{J>0&&(x==J||x==null)&&(B.show=w.show,hS(J),s==2?(hr(B.facets[0].scale,null,null),hr(B.facets[1].scale,null,null)):hr(B.scale,null,null),qn())}),P!==!1&&On("setSeries",x,w),L&&Ra("setSeries",i,x,w)}i.setSeries=vs;function dS(x,w){An(I[x],w)}function fS(x,w){x.fill=wt(x.fill||null),x.dir=It(x.dir,-1),w=w??I.length,I.splice(w,0,x)}function pS(x){x==null?I.length=0:I.splice(x,1)}i.addBand=fS,i.setBand=dS,i.delBand=pS;function mS(x,w){y[x].alpha=w,ge&&ht[x]!=null&&(ht[x].style.opacity=w),ee&&ct[x]&&(ct[x].style.opacity=w)}let Hs,dr,Nr,yo={focus:!0};function gS(x){if(x!=Nr){let w=x==null,P=Be.alpha!=1;y.forEach((L,B)=>{if(s==1||B>0){let J=w||B==0||B==x;L._focus=w?null:J,P&&mS(B,J?1:Be.alpha)}}),Nr=x,P&&qn()}}ee&&tt&&At(t0,Ce,x=>{de._lock||(et(x),Nr!=null&&vs(null,yo,!0,Sn.setSeries))});function bs(x,w,P){let L=M[w];P&&(x=x/Dt-(L.ori==1?ut:Je));let B=k;L.ori==1&&(B=Pe,x=B-x),L.dir==-1&&(x=B-x);let J=L._min,le=L._max,pe=x/B,be=J+(le-J)*pe,Fe=L.distr;return Fe==3?Ro(10,be):Fe==4?bM(be,L.asinh):Fe==100?L.bwd(be):be}function _S(x,w){let P=bs(x,C,w);return as(P,e[0],pn,mn)}i.valToIdx=x=>as(x,e[0]),i.posToIdx=_S,i.posToVal=bs,i.valToPos=(x,w,P)=>M[w].ori==0?r(x,M[w],P?$:k,P?R:0):o(x,M[w],P?he:Pe,P?S:0),i.setCursor=(x,w,P)=>{Kt=x.left,sn=x.top,Fr(null,w,P)};function Om(x,w){en(xo,Ao,jt.left=x),en(xo,Ba,jt.width=w)}function Bm(x,w){en(xo,"top",jt.top=x),en(xo,Va,jt.height=w)}let Aa=D.ori==0?Om:Bm,Ea=D.ori==1?Om:Bm;function xS(){if(ee&&fe.live)for(let x=s==2?1:0;x<y.length;x++){if(x==0&&ft)continue;let w=fe.values[x],P=0;for(let L in w)We[x][P++].firstChild.nodeValue=w[L]}}function Rd(x,w){if(x!=null&&(x.idxs?x.idxs.forEach((P,L)=>{re[L]=P}):TM(x.idx)||re.fill(x.idx),fe.idx=re[0]),ee&&fe.live){for(let P=0;P<y.length;P++)(P>0||s==1&&!ft)&&yS(P,re[P]);xS()}me=!1,w!==!1&&On("setLegend")}i.setLegend=Rd;function yS(x,w){let P=y[x],L=x==0&&G==2?_i:e[x],B;ft?B=P.values(i,x,w)??ot:(B=P.value(i,w==null?null:L[w],x,w),B=B==null?ot:{_:B}),fe.values[x]=B}function Fr(x,w,P){Um=Kt,km=sn,[Kt,sn]=de.move(i,Kt,sn),de.left=Kt,de.top=sn,ge&&(po&&Es(po,In(Kt),0,k,Pe),mo&&Es(mo,0,In(sn),k,Pe));let L,B=pn>mn;Hs=$t,dr=null;let J=D.ori==0?k:Pe,le=D.ori==1?k:Pe;if(Kt<0||cn==0||B){L=de.idx=null;for(let pe=0;pe<y.length;pe++){let be=ht[pe];be!=null&&Es(be,-10,-10,k,Pe)}tt&&vs(null,yo,!0,x==null&&Sn.setSeries),fe.live&&(re.fill(L),me=!0)}else{let pe,be,Fe;s==1&&(pe=D.ori==0?Kt:sn,be=bs(pe,C),L=de.idx=as(be,e[0],pn,mn),Fe=V(e[0][L],D,J,0));let Ue=-10,Oe=-10,at=0,Lt=0,Pt=!0,St="",Qe="";for(let qe=s==2?1:0;qe<y.length;qe++){let Qt=y[qe],hn=re[qe],Bn=hn==null?null:s==1?e[qe][hn]:e[qe][1][hn],Gt=de.dataIdx(i,qe,L,be),dn=Gt==null?null:s==1?e[qe][Gt]:e[qe][1][Gt];if(me=me||dn!=Bn||Gt!=hn,re[qe]=Gt,qe>0&&Qt.show){let xi=Gt==null?-10:Gt==L?Fe:V(s==1?e[0][Gt]:e[qe][0][Gt],D,J,0),ti=dn==null?-10:N(dn,s==1?M[Qt.scale]:M[Qt.facets[1].scale],le,0);if(tt&&dn!=null){let Vi=D.ori==1?Kt:sn,es=Ln(Be.dist(i,qe,Gt,ti,Vi));if(es<Hs){let Ss=Be.bias;if(Ss!=0){let yi=bs(Vi,Qt.scale),zi=dn>=0?1:-1,ts=yi>=0?1:-1;ts==zi&&(ts==1?Ss==1?dn>=yi:dn<=yi:Ss==1?dn<=yi:dn>=yi)&&(Hs=es,dr=qe)}else Hs=es,dr=qe}}if(me||Re){let Vi,es;D.ori==0?(Vi=xi,es=ti):(Vi=ti,es=xi);let Ss,yi,zi,ts,Ms,ni,vi=!0,Ur=ce.bbox;if(Ur!=null){vi=!1;let ii=Ur(i,qe);zi=ii.left,ts=ii.top,Ss=ii.width,yi=ii.height}else zi=Vi,ts=es,Ss=yi=ce.size(i,qe);if(ni=ce.fill(i,qe),Ms=ce.stroke(i,qe),Re)qe==dr&&Hs<=Be.prox&&(Ue=zi,Oe=ts,at=Ss,Lt=yi,Pt=vi,St=ni,Qe=Ms);else{let ii=ht[qe];ii!=null&&(Zt[qe]=zi,Qn[qe]=ts,l0(ii,Ss,yi,vi),o0(ii,ni,Ms),Es(ii,$i(zi),$i(ts),k,Pe))}}}}if(Re){let qe=Be.prox,Qt=Nr==null?Hs<=qe:Hs>qe||dr!=Nr;if(me||Qt){let hn=ht[0];hn!=null&&(Zt[0]=Ue,Qn[0]=Oe,l0(hn,at,Lt,Pt),o0(hn,St,Qe),Es(hn,$i(Ue),$i(Oe),k,Pe))}}}if(jt.show&&ur)if(x!=null){let[pe,be]=Sn.scales,[Fe,Ue]=Sn.match,[Oe,at]=x.cursor.sync.scales,Lt=x.cursor.drag;if(Un=Lt._x,kn=Lt._y,Un||kn){let{left:Pt,top:St,width:Qe,height:qe}=x.select,Qt=x.scales[Oe].ori,hn=x.posToVal,Bn,Gt,dn,xi,ti,Vi=pe!=null&&Fe(pe,Oe),es=be!=null&&Ue(be,at);Vi&&Un?(Qt==0?(Bn=Pt,Gt=Qe):(Bn=St,Gt=qe),dn=M[pe],xi=V(hn(Bn,Oe),dn,J,0),ti=V(hn(Bn+Gt,Oe),dn,J,0),Aa(ls(xi,ti),Ln(ti-xi))):Aa(0,J),es&&kn?(Qt==1?(Bn=Pt,Gt=Qe):(Bn=St,Gt=qe),dn=M[be],xi=N(hn(Bn,at),dn,le,0),ti=N(hn(Bn+Gt,at),dn,le,0),Ea(ls(xi,ti),Ln(ti-xi))):Ea(0,le)}else Ld()}else{let pe=Ln(Um-Nm),be=Ln(km-Fm);if(D.ori==1){let at=pe;pe=be,be=at}Un=Wn.x&&pe>=Wn.dist,kn=Wn.y&&be>=Wn.dist;let Fe=Wn.uni;Fe!=null?Un&&kn&&(Un=pe>=Fe,kn=be>=Fe,!Un&&!kn&&(be>pe?kn=!0:Un=!0)):Wn.x&&Wn.y&&(Un||kn)&&(Un=kn=!0);let Ue,Oe;Un&&(D.ori==0?(Ue=go,Oe=Kt):(Ue=_o,Oe=sn),Aa(ls(Ue,Oe),Ln(Oe-Ue)),kn||Ea(0,le)),kn&&(D.ori==1?(Ue=go,Oe=Kt):(Ue=_o,Oe=sn),Ea(ls(Ue,Oe),Ln(Oe-Ue)),Un||Aa(0,J)),!Un&&!kn&&(Aa(0,0),Ea(0,0))}if(Wn._x=Un,Wn._y=kn,x==null){if(P){if(Zm!=null){let[pe,be]=Sn.scales;Sn.values[0]=pe!=null?bs(D.ori==0?Kt:sn,pe):null,Sn.values[1]=be!=null?bs(D.ori==1?Kt:sn,be):null}Ra(tf,i,Kt,sn,k,Pe,L)}if(tt){let pe=P&&Sn.setSeries,be=Be.prox;Nr==null?Hs<=be&&vs(dr,yo,!0,pe):Hs>be?vs(null,yo,!0,pe):dr!=Nr&&vs(dr,yo,!0,pe)}}me&&(fe.idx=L,Rd()),w!==!1&&On("setCursor")}let fr=null;Object.defineProperty(i,"rect",{get(){return fr==null&&Ca(!1),fr}});function Ca(x=!1){x?fr=null:(fr=m.getBoundingClientRect(),On("syncRect",fr))}function Vm(x,w,P,L,B,J,le){de._lock||ur&&x!=null&&x.movementX==0&&x.movementY==0||(Pd(x,w,P,L,B,J,le,!1,x!=null),x!=null?Fr(null,!0,!0):Fr(w,!0,!1))}function Pd(x,w,P,L,B,J,le,pe,be){if(fr==null&&Ca(!1),et(x),x!=null)P=x.clientX-fr.left,L=x.clientY-fr.top;else{if(P<0||L<0){Kt=-10,sn=-10;return}let[Fe,Ue]=Sn.scales,Oe=w.cursor.sync,[at,Lt]=Oe.values,[Pt,St]=Oe.scales,[Qe,qe]=Sn.match,Qt=w.axes[0].side%2==1,hn=D.ori==0?k:Pe,Bn=D.ori==1?k:Pe,Gt=Qt?J:B,dn=Qt?B:J,xi=Qt?L:P,ti=Qt?P:L;if(Pt!=null?P=Qe(Fe,Pt)?a(at,M[Fe],hn,0):-10:P=hn*(xi/Gt),St!=null?L=qe(Ue,St)?a(Lt,M[Ue],Bn,0):-10:L=Bn*(ti/dn),D.ori==1){let Vi=P;P=L,L=Vi}}be&&(w==null||w.cursor.event.type==tf)&&((P<=1||P>=k-1)&&(P=Br(P,k)),(L<=1||L>=Pe-1)&&(L=Br(L,Pe))),pe?(Nm=P,Fm=L,[go,_o]=de.move(i,P,L)):(Kt=P,sn=L)}let Id={width:0,height:0,left:0,top:0};function Ld(){Wl(Id,!1)}let zm,Gm,Hm,Wm;function $m(x,w,P,L,B,J,le){ur=!0,Un=kn=Wn._x=Wn._y=!1,Pd(x,w,P,L,B,J,le,!0,!1),x!=null&&(At(nf,lf,Xm,!1),Ra(Qg,i,go,_o,k,Pe,null));let{left:pe,top:be,width:Fe,height:Ue}=jt;zm=pe,Gm=be,Hm=Fe,Wm=Ue}function Xm(x,w,P,L,B,J,le){ur=Wn._x=Wn._y=!1,Pd(x,w,P,L,B,J,le,!1,!0);let{left:pe,top:be,width:Fe,height:Ue}=jt,Oe=Fe>0||Ue>0,at=zm!=pe||Gm!=be||Hm!=Fe||Wm!=Ue;if(Oe&&at&&Wl(jt),Wn.setScale&&Oe&&at){let Lt=pe,Pt=Fe,St=be,Qe=Ue;if(D.ori==1&&(Lt=be,Pt=Ue,St=pe,Qe=Fe),Un&&hr(C,bs(Lt,C),bs(Lt+Pt,C)),kn)for(let qe in M){let Qt=M[qe];qe!=C&&Qt.from==null&&Qt.min!=$t&&hr(qe,bs(St+Qe,qe),bs(St,qe))}Ld()}else de.lock&&(de._lock=!de._lock,Fr(w,!0,x!=null));x!=null&&(Rn(nf,lf),Ra(nf,i,Kt,sn,k,Pe,null))}function vS(x,w,P,L,B,J,le){if(de._lock)return;et(x);let pe=ur;if(ur){let be=!0,Fe=!0,Ue=10,Oe,at;D.ori==0?(Oe=Un,at=kn):(Oe=kn,at=Un),Oe&&at&&(be=Kt<=Ue||Kt>=k-Ue,Fe=sn<=Ue||sn>=Pe-Ue),Oe&&be&&(Kt=Kt<go?0:k),at&&Fe&&(sn=sn<_o?0:Pe),Fr(null,!0,!0),ur=!1}Kt=-10,sn=-10,re.fill(null),Fr(null,!0,!0),pe&&(ur=pe)}function qm(x,w,P,L,B,J,le){de._lock||(et(x),Ta(),Ld(),x!=null&&Ra(n0,i,Kt,sn,k,Pe,null))}function Ym(){E.forEach(zw),U(i.width,i.height,!0)}Gr(pc,Co,Ym);let vo={};vo.mousedown=$m,vo.mousemove=Vm,vo.mouseup=Xm,vo.dblclick=qm,vo.setSeries=(x,w,P,L)=>{let B=Sn.match[2];P=B(i,w,P),P!=-1&&vs(P,L,!0,!1)},ge&&(At(Qg,m,$m),At(tf,m,Vm),At(e0,m,x=>{et(x),Ca(!1)}),At(t0,m,vS),At(n0,m,qm),gf.add(i),i.syncRect=Ca);let $l=i.hooks=n.hooks||{};function On(x,w,P){ei?Ot.push([x,w,P]):x in $l&&$l[x].forEach(L=>{L.call(null,i,w,P)})}(n.plugins||[]).forEach(x=>{for(let w in x.hooks)$l[w]=($l[w]||[]).concat(x.hooks[w])});let Jm=(x,w,P)=>P,Sn=An({key:null,setSeries:!1,filters:{pub:f0,sub:f0},scales:[C,y[1]?y[1].scale:null],match:[p0,p0,Jm],values:[null,null]},de.sync);Sn.match.length==2&&Sn.match.push(Jm),de.sync=Sn;let Zm=Sn.key,Dd=u_(Zm);function Ra(x,w,P,L,B,J,le){Sn.filters.pub(x,w,P,L,B,J,le)&&Dd.pub(x,w,P,L,B,J,le)}Dd.sub(i);function bS(x,w,P,L,B,J,le){Sn.filters.sub(x,w,P,L,B,J,le)&&vo[x](null,w,P,L,B,J,le)}i.pub=bS;function SS(){Dd.unsub(i),gf.delete(i),Fn.clear(),hf(pc,Co,Ym),c.remove(),Ce?.remove(),On("destroy")}i.destroy=SS;function Nd(){On("init",n,e),wa(e||n.data,!1),W[C]?Ad(C,W[C]):Ta(),se=jt.show&&(jt.width>0||jt.height>0),ne=me=!0,U(n.width,n.height)}return y.forEach(co),E.forEach(Bs),t?t instanceof HTMLElement?(t.appendChild(c),Nd()):t(i,Nd):Nd(),i}En.assign=An;En.fmtNum=Mf;En.rangeNum=mc;En.rangeLog=xc;En.rangeAsinh=bf;En.orient=Wr;En.pxRatio=Dt;En.join=LM;En.fmtDate=Tf,En.tzDate=HM;En.sync=u_;{En.addGap=Tw,En.clipGaps=bc;let n=En.paths={points:g_};n.linear=x_,n.stepped=Cw,n.bars=Rw,n.spline=Iw}var S_=7;function Gw(n,e,t){let{left:i,width:s}=n.bbox;e.forEach((r,o)=>{if(r.faint)return;let a=n.data[o+1];for(let l=0;l<S_;++l){let c=i+s*(l+(o+1)/(e.length+1))/S_,u=n.posToIdx(c,!0);for(;u<a.length&&a[u]==null;)++u;let f=a[u];if(f==null)continue;let d=n.valToPos(n.data[0][u],"x",!0);d<=i+s&&zg(n.ctx,r.style,d,n.valToPos(f,"y",!0),t)}})}function Hw(n,e,t,i){if(e.allowed==null||!(e.allowed>0))return;let{left:s,width:r,top:o,height:a}=n.bbox,l=n.valToPos(e.allowed,"y",!0);l<o||l>o+a||(n.ctx.strokeStyle=n.ctx.fillStyle=si(Hi(e.style).color),n.ctx.lineWidth=1.5*t,n.ctx.setLineDash([3*t,3*t]),n.ctx.beginPath(),n.ctx.moveTo(s,l),n.ctx.lineTo(s+r,l),n.ctx.stroke(),n.ctx.setLineDash([]),n.ctx.font=`${11*t}px system-ui, sans-serif`,n.ctx.textAlign="right",n.ctx.fillText(i,s+r-4*t,l-4*t))}function Ww(n,e,t){if(!e.violation)return;let{left:i,width:s,top:r,height:o}=n.bbox,a=n.valToPos(e.violation.time,"x",!0);if(a<i||a>i+s)return;let{value:l}=e.violation,c=l===null?r:Math.min(r+o,Math.max(r,n.valToPos(l,"y",!0)));n.ctx.strokeStyle=si("--ink"),n.ctx.lineWidth=2*t,n.ctx.beginPath(),n.ctx.arc(a,c,7*t,0,2*Math.PI),n.ctx.moveTo(a-4*t,c-4*t),n.ctx.lineTo(a+4*t,c+4*t),n.ctx.moveTo(a-4*t,c+4*t),n.ctx.lineTo(a+4*t,c-4*t),n.ctx.stroke()}function M_(n,e,t){let i=devicePixelRatio;n.ctx.save();let s=new Set;for(let r of e)r.allowed==null||s.has(r.allowed)||(s.add(r.allowed),Hw(n,r,i,t(r.allowed)));Gw(n,e,i);for(let r of e)Ww(n,r,i);n.ctx.restore()}var w_=Array.from({length:130},(n,e)=>e-50).flatMap(n=>[1,2,5].map(e=>+`${e}e${n}`));function $w(n){let e={stroke:()=>si("--ink"),grid:{stroke:()=>si("--line"),width:1},ticks:{stroke:()=>si("--line"),width:1},font:"12px system-ui, sans-serif",labelFont:"12px system-ui, sans-serif",labelSize:18,labelGap:0},t=(i,s)=>s.map(r=>r===null?"":n.number(r));return[{...e,label:"time [s]",values:t,incrs:w_,size:34},{...e,label:n.axis,values:t,incrs:w_,size:64,...n.log?{splits:Jw,filter:(i,s)=>s}:{}}]}function Xw(n,e,t){let i=Math.floor(Math.log10(e));return[10**i,10**Math.max(i+1,Math.ceil(Math.log10(t)))]}var qw=680,Yw=22;function Jw(n,e,t,i){let[s,r]=[Math.round(Math.log10(t)),Math.round(Math.log10(i))],o=Math.max(2,n.bbox.height/devicePixelRatio/Yw),a=Math.ceil((r-s)/o),l=3*(r-s)<=o?[1,2,5]:[1],c=[];for(let u=s;u<=r;u+=a)for(let f of l)c.push(f*10**u);return c.filter(u=>u<=i)}function Zw(n,e,t){return e==null||t==null?[-1,1]:e===t?[e-(Math.abs(e)||1),e+(Math.abs(e)||1)]:En.rangeNum(e,t,.1,!0)}function Kw(n,e){let{curves:t,cursor:i,log:s}=n,r=t.flatMap(l=>l.allowed!=null&&l.allowed>0?[l.allowed]:[]),[o,a]=i.window??i.whole;return{width:e,height:n.height??260,legend:{show:!1},scales:{x:{time:!1,auto:!1,min:o,max:a},y:s?{distr:3,range:(l,c,u)=>Xw(l,Math.min(c??1,...r),Math.max(u??1,...r))}:{range:Zw}},series:[{},...t.map(l=>({stroke:()=>si(Hi(l.style).color),width:l.faint?1:2,dash:Hi(l.style).dash,points:{show:!1}}))],axes:$w(n),cursor:{y:!1,points:{size:7},drag:{dist:6,x:!0,y:!1}},hooks:{setScale:[(l,c)=>{let{min:u,max:f}=l.scales.x;c==="x"&&u!=null&&f!=null&&(i.window=[u,f])}],draw:[l=>M_(l,t,c=>`allowed ${n.number(c)}`)]}}}function Lf(n,e){let[t,i]=e.window??e.whole;i>t&&(n.scales.x.min!==t||n.scales.x.max!==i)&&n.setScale("x",{min:t,max:i}),n.setCursor({left:n.valToPos(e.time,"x"),top:0},!1)}function jw(n,e){let t=i=>n.posToVal(i.clientX-n.over.getBoundingClientRect().left,"x");n.over.addEventListener("mousemove",i=>e.hover(t(i))),n.over.addEventListener("mouseleave",()=>{e.hover(null),queueMicrotask(()=>Lf(n,e))}),n.over.addEventListener("click",i=>e.pin=t(i)),n.over.addEventListener("dblclick",()=>e.window=null)}function Tc(n){let e=Vt(null),{curves:t,cursor:i,log:s,axis:r,height:o}=n;return Rt(()=>{let a=e.current,l=Xg(t,s?$g(t):null),c=new En(Kw(n,Math.max(200,a.clientWidth)),l,a);jw(c,i);let u=()=>{let m=Math.max(200,a.clientWidth);m!==c.width&&c.setSize({width:m,height:c.height})},f=()=>c.setSize({width:qw,height:c.height}),d=new ResizeObserver(u);d.observe(a),addEventListener("beforeprint",f),addEventListener("afterprint",u);let p=[i.listen(()=>Lf(c,i)),So(()=>c.redraw(!1))];return queueMicrotask(()=>Lf(c,i)),()=>{d.disconnect(),removeEventListener("beforeprint",f),removeEventListener("afterprint",u);for(let m of p)m();c.destroy()}},[t,i,s,r,o]),h("div",{class:"plot",ref:e,role:"img","aria-label":n.label})}function Qw(n,e){let t=As(n.time,e);return t<0?"no samples":`${De(n.value[t])} at ${De(n.time[t],5)} s`}function e1(n,e){let t=lc(n);if(!t)return n.value.length===0?"no samples":"nothing finite";let i=[];return e&&t.zeros>0&&i.push(`${on(t.zeros,"sample")} exactly 0, drawn on the lower edge`),t.lost>0&&i.push(`${on(t.lost,"sample")} not finite (or above 3.4e38), the first at ${De(t.lostAt)} s`),i.join("; ")}function t1({curve:n,cursor:e,log:t,violations:i}){let s=ac(e),r=He(()=>lc(n),[n]),o=n.violation;return h("tr",{children:[h("th",{scope:"row",children:[h(Ts,{style:n.style,faint:n.faint??!1})," ",te(n.label)]}),h("td",{class:"number at-cursor",children:Qw(n,s)}),h("td",{class:"number",children:r?`${De(r.least)} at ${De(r.leastAt)} s`:""}),h("td",{class:"number",children:r?`${De(r.greatest)} at ${De(r.greatestAt)} s`:""}),i?h("td",{class:"number",children:o?`${De(o.value)} at ${De(o.time)} s`:""}):null,h("td",{children:e1(n,t)})]})}function Ac({curves:n,cursor:e,log:t,unit:i,caption:s}){let r=n.some(a=>a.violation),o=[`curve${i?` [${i}]`:""}`,"at the cursor","least","greatest"];return o.push(...r?["first violation","remarks"]:["remarks"]),h("div",{class:"scroll curves",tabIndex:0,role:"region","aria-label":s,children:h("table",{children:[h("thead",{children:h("tr",{children:o.map(a=>h("th",{scope:"col",children:a},a))})}),h("tbody",{children:n.map((a,l)=>h(t1,{curve:a,cursor:e,log:t,violations:r},l))})]})})}function Ec(n,e,t){let i=e.map(s=>{let r=lc(s),o=r?`greatest ${De(r.greatest)} ${t} at ${De(r.greatestAt)} s`:"nothing finite",a=s.violation?`, first beyond its tolerance at ${De(s.violation.time)} s`:"";return`${te(s.label)}: ${o}${a}`});return`${n}. ${i.join(". ")}.`}function T_(n,e,t,i,s){let r=t&&e.allowed?e.allowed:1,o=n.floats(e.value),a=e.first_violation;return{label:i,style:s,time:n.floats(e.time),value:r===1?o:o.map(l=>l/r),allowed:t?1:e.allowed,violation:a?{time:a.time,value:a.value===null?null:a.value/r}:null}}function n1(n,e,t,i){let s=new Map,r=(o,a)=>{let l=i?"":o,c=s.get(l)??{unit:l,curves:[]};c.curves.push(a),s.set(l,c)};for(let{curve:o,index:a}of n){if(!o||i&&!o.allowed)continue;r(o.unit,T_(e,o,i,o.claim,a));let l=t?.block.trace.errors.find(c=>c.claim===o.claim);t&&l&&r(l.unit,{...T_(t.block,l,i,`${t.engine}: ${l.claim}`,a),faint:!0})}return[...s.values()]}function A_({rows:n,block:e,other:t,cursor:i}){let[s,r]=lt(null),o=new Set(n.flatMap(u=>u.curve?[u.curve.unit]:[])),a=s??o.size>1,l=He(()=>n1(n,e,t,a),[n,e,t,a]),c=n.filter(u=>!u.curve?.allowed).length;return h("section",{"aria-labelledby":"errors-heading",children:[h("h3",{id:"errors-heading",children:"Errors against time"}),h("fieldset",{class:"choice on-screen",children:[h("legend",{class:"unseen",children:"Scale of the errors"}),h("label",{children:[h("input",{type:"radio",name:"error-scale",checked:!a,onChange:()=>r(!1)})," in their units"]}),h("label",{children:[h("input",{type:"radio",name:"error-scale",checked:a,onChange:()=>r(!0)})," over what is allowed"]})]}),l.length===0?h("p",{class:"empty",children:"No claim is chosen: tick claims in the table above."}):null,a&&c>0?h("p",{class:"note",children:[c," of the chosen claims allow nothing and are left out."]}):null,l.map(({unit:u,curves:f})=>{let d=a?"error / allowed":`error [${u||"1"}]`;return h("figure",{children:[h(Tc,{curves:f,label:Ec("Errors against time",f,a?"times what is allowed":u),axis:d,log:!0,cursor:i,number:De}),h("figcaption",{children:h(Ac,{curves:f,cursor:i,log:!0,unit:a?"of allowed":u,caption:d})})]},u)}),h("p",{class:"note",children:"Dashed levels: what is allowed. Ringed crosses: the first violation. Drag to look closer, double-click for all."})]})}var E_=12;function Xi(n){let[e,t]=lt(!1);Rt(()=>{let s=()=>t(!0);return addEventListener("beforeprint",s),()=>removeEventListener("beforeprint",s)},[]);let i=n.length>E_&&!e?h("button",{type:"button",onClick:()=>t(!0),children:["show all ",n.length]}):null;return{list:e?n:n.slice(0,E_),button:i}}function C_({events:n,cursor:e}){let{list:t,button:i}=Xi(n);return h("section",{"aria-labelledby":"events-heading",children:[h("h3",{id:"events-heading",children:"Events"}),n.length===0?h("p",{class:"empty",children:"None was recorded."}):null,n.length>0?h("table",{children:[h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"time"}),h("th",{scope:"col",children:"kind"}),h("th",{scope:"col",children:"what"})]})}),h("tbody",{children:t.map((s,r)=>h("tr",{children:[h("td",{class:"number",children:h("button",{type:"button",class:"plain-on-paper",onClick:()=>e.pin=s.time,title:"move the cursor here",children:[De(s.time,8)," s"]})}),h("td",{children:te(s.kind)}),h("td",{children:te(s.what)})]},r))})]}):null,i]})}var je=(n,e)=>[n[0]+e[0],n[1]+e[1],n[2]+e[2]],mt=(n,e)=>[n[0]-e[0],n[1]-e[1],n[2]-e[2]],nt=(n,e)=>[e*n[0],e*n[1],e*n[2]],xt=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],qs=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],Tt=n=>Math.hypot(n[0],n[1],n[2]),ai=n=>{for(let e=0;e<n.length;++e)if(!Number.isFinite(n[e]))return!1;return!0};function di(n,e){let t=Tt(n);return t>0&&Number.isFinite(t)?nt(n,1/t):e}function Ys(n){let[e,t,i]=[Math.abs(n[0]),Math.abs(n[1]),Math.abs(n[2])],s=e<=t&&e<=i?[1,0,0]:i<=t?[0,0,1]:[0,1,0],r=di(qs(n,s),[0,1,0]);return[qs(r,n),r]}function Yt(n,e){let t=[n[1],n[2],n[3]];return je(e,nt(qs(t,je(qs(t,e),nt(e,n[0]))),2))}var qi=n=>[n[0],-n[1],-n[2],-n[3]],yr=(n,e)=>[n[0]*e[0]-n[1]*e[1]-n[2]*e[2]-n[3]*e[3],n[0]*e[1]+n[1]*e[0]+n[2]*e[3]-n[3]*e[2],n[0]*e[2]-n[1]*e[3]+n[2]*e[0]+n[3]*e[1],n[0]*e[3]+n[1]*e[2]-n[2]*e[1]+n[3]*e[0]];function i1(n){let e=[0,1,2].map(i=>n.slice(3*i,3*i+3)),t=[1,0,0,0];for(let i=0;i<12;++i)for(let[s,r]of[[0,1],[0,2],[1,2]]){let o=(e[s][r]+e[r][s])/2;if(!(Math.abs(o)>1e-15*(Math.abs(e[s][s])+Math.abs(e[r][r]))))continue;let a=Math.atan2(2*o,e[s][s]-e[r][r])/2,[l,c]=[Math.cos(a),Math.sin(a)];for(let d=0;d<3;++d)[e[d][s],e[d][r]]=[l*e[d][s]+c*e[d][r],l*e[d][r]-c*e[d][s]];for(let d=0;d<3;++d)[e[s][d],e[r][d]]=[l*e[s][d]+c*e[r][d],l*e[r][d]-c*e[s][d]];let u=3-s-r,f=[Math.cos(a/2),0,0,0];f[1+u]=Math.sin(a/2)*(u===1?-1:1),t=yr(t,f)}return{moments:[e[0][0],e[1][1],e[2][2]],turn:t}}var s1=.04;function Uo(n){if(n.shape)return n.shape;let{moments:e,turn:t}=i1(n.inertia),[i,s,r]=e,o=Math.max(i,s,r);if(!(n.mass>0)||!(o>0)||!Number.isFinite(o/n.mass)||o-Math.min(i,s,r)<=1e-9*o)return null;let a=[s+r-i,r+i-s,i+s-r].map(u=>Math.sqrt(Math.max(0,1.5*u/n.mass))),l=s1*Math.max(...a),c={type:"box",half_extents:a.map(u=>Math.max(u,l))};return t[0]===1?c:{type:"compound",parts:[{shape:c,mass:n.mass,position:[0,0,0],orientation:t}]}}var r1=(n,e)=>n.reduce((t,i)=>Math.max(t,xt(i,e)),-1/0);function R_(n,e){if(!n)return 0;let t=Math.hypot(e[0],e[2]);switch(n.type){case"sphere":return n.radius;case"box":return n.half_extents.reduce((i,s,r)=>i+s*Math.abs(e[r]),0);case"capsule":return n.radius+n.length/2*Math.abs(e[1]);case"cylinder":return n.radius*t+n.length/2*Math.abs(e[1]);case"cone":return Math.max(.75*n.length*e[1],n.radius*t-.25*n.length*e[1]);case"rod":return n.length/2*Math.abs(e[1]);case"disc":return n.radius*t;case"hull":case"mesh":return r1(n.vertices,e);case"compound":return Math.max(...n.parts.map(i=>xt(i.position,e)+R_(i.shape,Yt(qi(i.orientation),e))))}}function P_(n,e,t){let i=s=>{let r=[0,0,0];return r[t]=s,R_(n,Yt(qi(e),r))};return{down:i(-1),up:i(1)}}function Rc(n){if(!n)return 0;switch(n.type){case"sphere":case"disc":return n.radius;case"box":return Tt(n.half_extents);case"capsule":return n.radius+n.length/2;case"cylinder":return Math.hypot(n.radius,n.length/2);case"cone":return Math.max(.75*n.length,Math.hypot(n.radius,n.length/4));case"rod":return n.length/2;case"hull":case"mesh":return n.vertices.reduce((e,t)=>Math.max(e,Tt(t)),0);case"compound":return n.parts.reduce((e,t)=>Math.max(e,Tt(t.position)+Rc(t.shape)),0)}}function Df(n,e,t){if(!(!ai(e)||!Number.isFinite(t)))for(let i=0;i<3;++i)n.min[i]=Math.min(n.min[i],e[i]-t),n.max[i]=Math.max(n.max[i],e[i]+t)}var o1=()=>({min:[1/0,1/0,1/0],max:[-1/0,-1/0,-1/0]});function Cc(n){if(!ai(n.min)||!ai(n.max))return{min:[-1,-1,-1],max:[1,1,1]};let e=Tt(mt(n.max,n.min)),t=e>0?.04*e:.5,i={min:[...n.min],max:[...n.max]};for(let s=0;s<3;++s){let r=t-(i.max[s]-i.min[s]);r>0&&(i.min[s]-=r/2,i.max[s]+=r/2)}return i}function a1(n,e,t){if(!ai(t.min)||!ai(t.max)||!ai(e.orientation))return;let i=Uo(e),s=Rc(i),r=t.max.map((a,l)=>a-t.min[l]),o=Math.max(...r);for(let a=0;a<3;++a){let l=e.locked||o>s&&r[a]<.02*o,{down:c,up:u}=l?P_(i,e.orientation,a):{down:s,up:s};Number.isFinite(c+u)&&(n.min[a]=Math.min(n.min[a],t.min[a]-c),n.max[a]=Math.max(n.max[a],t.max[a]+u))}}function ko(n,e){let t=o1();for(let o of n.body){let a={min:o.position,max:o.position};a1(t,o,o.locked?a:e??a)}for(let o of n.spring)o.pin&&Df(t,o.pin,0);for(let o of n.joint)o.point&&Df(t,o.point,0);if(!ai(t.min))return Cc(t);let i=nt(je(t.min,t.max),.5),s=Math.max(Tt(mt(t.max,t.min)),.001),r=o=>{Tt(mt(o,i))<6*s&&Df(t,o,0)};for(let o of n.plane)r(je(i,nt(o.normal,o.offset-xt(o.normal,i))));for(let o of n.water)r([i[0],o.level,i[2]]);return Cc(t)}function Pc(n){if(!(n>0)||!Number.isFinite(n))return 1;let e=10**Math.floor(Math.log10(n)),t=n/e;return(t>=5?5:t>=2?2:1)*e}var I_=["#0072b2","#e69f00","#009e73","#cc79a7","#56b4e9","#d55e00","#c9b800","#8a8a8a"];function Yi(n){let e=/^#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})$/i.exec(n);return e?e.slice(1).map(t=>parseInt(t,16)/255):null}function D_(n,e){let t=Yi(n.color)??Yi(I_[e%I_.length]);return n.locked?t.map(i=>.62*i):t}var l1={velocity:Yi("#0b5cad"),momentum:Yi("#0a7d4f"),"angular momentum":Yi("#8b3fa8"),impulse:Yi("#c2410c"),normal:Yi("#666666")},c1={velocity:Yi("#6db6ff"),momentum:Yi("#4ade9c"),"angular momentum":Yi("#d79bf0"),impulse:Yi("#ff9d5c"),normal:Yi("#b0b0b0")},Cs=(n,e,t)=>[n[0]+t*(e[0]-n[0]),n[1]+t*(e[1]-n[1]),n[2]+t*(e[2]-n[2])],Ti=n=>`rgb(${n.map(e=>Math.round(255*e)).join(" ")})`;function L_(n,e){let t=n&&document.createElement("canvas").getContext("2d");if(!t)return e;t.canvas.width=t.canvas.height=1,t.fillStyle="#010203",t.fillStyle=n,t.fillRect(0,0,1,1);let[i,s,r]=t.getImageData(0,0,1,1).data;return i===1&&s===2&&r===3?e:[i/255,s/255,r/255]}function Nf(n){let e=getComputedStyle(n),t=matchMedia("(prefers-color-scheme: dark)").matches,i=L_(e.getPropertyValue("--ground").trim(),t?[.07,.08,.1]:[1,1,1]),s=L_(e.getPropertyValue("--ink").trim(),t?[.92,.93,.95]:[.1,.1,.12]),r=o=>.3*o[0]+.6*o[1]+.1*o[2];return{ground:i,ink:s,faint:Cs(i,s,.22),arrows:r(i)<.5?c1:l1}}var $a=40*Math.PI/180,N_=Math.PI/2-.001;function F_(n){return{target:[...n.target],distance:Math.min(Math.max(n.distance,1e-6),1e15),azimuth:n.azimuth%(2*Math.PI),elevation:Math.min(Math.max(n.elevation,-N_),N_)}}function Ic(n){let{azimuth:e,elevation:t}=n,i=[Math.cos(t)*Math.sin(e),Math.sin(t),Math.cos(t)*Math.cos(e)],s=[Math.cos(e),0,-Math.sin(e)];return[s,qs(i,s),i]}function U_(n,e,t){let[i,s,r]=Ic(n),{target:o,distance:a}=n,l=5*a+20*t,c=Math.max(.01*a,1e-5*l);return{eye:je(o,nt(r,a)),right:i,up:s,back:r,target:o,distance:a,near:c,far:l,...e}}var cs=n=>2*n.distance*Math.tan($a/2)/n.height;function k_(n,e,t){let i=Math.tan($a/2)/(n.height/2),s=je(nt(n.right,(e-n.width/2)*i),nt(n.up,(n.height/2-t)*i));return{from:n.eye,along:mt(s,n.back)}}function O_(n,e,t){let i=cs(n),s=je(nt(n.right,(e-n.width/2)*i),nt(n.up,(n.height/2-t)*i));return{from:je(n.eye,s),along:nt(n.back,-1)}}function Ai(n,e){let t=mt(e,n.target),i=1/cs(n);return{x:n.width/2+i*xt(t,n.right),y:n.height/2-i*xt(t,n.up),depth:n.distance-xt(t,n.back)}}function Ff(n,e){let t=nt(je(n.min,n.max),.5),i=nt(mt(n.max,n.min),.5),s=i[2]<.4*Math.max(i[0],i[1]),r={target:t,distance:1,azimuth:s?.25:.55,elevation:s?.16:.3},[o,a,l]=Ic(r),c=Math.tan($a/2),u=c*e,f=0;for(let d=0;d<8;++d){let p=[d&1?i[0]:-i[0],d&2?i[1]:-i[1],d&4?i[2]:-i[2]],m=Math.max(Math.abs(xt(p,o))/u,Math.abs(xt(p,a))/c);f=Math.max(f,m+xt(p,l))}return r.distance=f>0?1.06*f:5,r}var B_=.008,Lc=Math.PI/36;function Xa(n,e,t){return{...n,azimuth:n.azimuth-e,elevation:n.elevation+t}}function Oo(n,e,t){let[i,s]=Ic(n);return{...n,target:je(n.target,je(nt(i,e),nt(s,t)))}}var qa=(n,e)=>({...n,distance:n.distance*e}),Dc=class{constructor(e,t){this.element=e;this.scene=t;let i={signal:this.stop.signal};e.addEventListener("pointerdown",this.down,i),e.addEventListener("pointermove",this.move,i),e.addEventListener("pointerup",this.up,i),e.addEventListener("pointercancel",this.up,i),e.addEventListener("wheel",this.wheel,{...i,passive:!1}),e.addEventListener("keydown",this.key,i),e.addEventListener("contextmenu",s=>s.preventDefault(),i)}element;scene;pointers=new Map;holds=!1;stop=new AbortController;down=e=>{this.element.focus({preventScroll:!0}),this.element.setPointerCapture(e.pointerId),this.pointers.set(e.pointerId,{x:e.offsetX,y:e.offsetY}),this.pointers.size>1?this.letGo():e.button===0&&!e.shiftKey&&(this.holds=this.scene.grab(e.offsetX,e.offsetY))};move=e=>{let t=this.pointers.get(e.pointerId);if(!t)return;let[i,s]=[e.offsetX,e.offsetY],[r,o]=[i-t.x,s-t.y];if(this.holds)this.scene.pull(i,s);else if(this.pointers.size===1){let a=this.scene.camera,l=this.scene.metresPerPixel(),c=e.shiftKey||(e.buttons&6)!==0;this.scene.moveCamera(c?Oo(a,-r*l,o*l):Xa(a,r*B_,o*B_))}else this.pointers.size===2&&this.pinch(e.pointerId,t,{x:i,y:s});this.pointers.set(e.pointerId,{x:i,y:s})};pinch(e,t,i){for(let[s,r]of this.pointers){if(s===e)continue;let o=Math.hypot(t.x-r.x,t.y-r.y),a=Math.hypot(i.x-r.x,i.y-r.y),l=this.scene.metresPerPixel()/2,c=o>4&&a>4?qa(this.scene.camera,o/a):this.scene.camera;this.scene.moveCamera(Oo(c,-(i.x-t.x)*l,(i.y-t.y)*l))}}up=e=>{this.pointers.delete(e.pointerId),this.letGo()};letGo(){this.holds&&this.scene.release(),this.holds=!1}wheel=e=>{e.preventDefault();let t=e.deltaMode===WheelEvent.DOM_DELTA_LINE?16:e.deltaMode===WheelEvent.DOM_DELTA_PAGE?300:1,i=Math.exp(Math.max(-120,Math.min(120,e.deltaY*t))*.0015);this.scene.moveCamera(qa(this.scene.camera,i))};key=e=>{if(e.ctrlKey||e.metaKey||e.altKey)return;let t=this.scene.camera,i=e.shiftKey?30*this.scene.metresPerPixel():0,r={ArrowLeft:()=>i?Oo(t,-i,0):Xa(t,Lc,0),ArrowRight:()=>i?Oo(t,i,0):Xa(t,-Lc,0),ArrowUp:()=>i?Oo(t,0,i):Xa(t,0,Lc),ArrowDown:()=>i?Oo(t,0,-i):Xa(t,0,-Lc),"+":()=>qa(t,1/1.15),"=":()=>qa(t,1/1.15),"-":()=>qa(t,1.15)}[e.key];if(r)this.scene.moveCamera(r());else if(e.key==="Home"||e.key==="0")this.scene.reset();else return;e.preventDefault(),e.stopPropagation()};dispose(){this.letGo(),this.stop.abort()}};var Uf=[[1e9,"Gm"],[1e6,"Mm"],[1e3,"km"],[1,"m"],[.01,"cm"],[.001,"mm"],[1e-6,"\xB5m"],[1e-9,"nm"]];function kf(n){let[e,t]=Uf.find(([i])=>n>=.9999*i)??Uf[Uf.length-1];return`${Number((n/e).toPrecision(3))} ${t}`}var Of=80;function V_(n,e,t,i){let{width:s,height:r,ratio:o}=e;n.setTransform(o,0,0,o,0,o*(Of-r)),n.clearRect(0,0,s,r),n.font="11px system-ui, sans-serif",n.textBaseline="middle";let a=Ti(Cs(t.ink,t.ground,.15));u1(n,e,a,Ti(t.ground)),h1(n,e,a,Ti(t.ground),i)}function z_(n,e,t,i,s,r){n.lineWidth=3,n.lineJoin="round",n.strokeStyle=r,n.strokeText(e,t,i),n.fillStyle=s,n.fillText(e,t,i)}function u1(n,{right:e,up:t,height:i},s,r){let[o,a,l]=[34,i-34,22],c=[[1,0,0],[0,1,0],[0,0,1]];n.textAlign="center",c.forEach((u,f)=>{let[d,p]=[e[f]*l,-t[f]*l];n.strokeStyle=s,n.lineWidth=1.5,n.beginPath(),n.moveTo(o,a),n.lineTo(o+d,a+p),n.stroke(),z_(n,"xyz"[f],o+1.35*d,a+1.35*p,s,r)})}function h1(n,e,t,i,s){let r=cs(e),o=Pc(Math.min(120,e.width/4)*r),[a,l]=[e.width-14,e.height-14],c=a-o/r;n.strokeStyle=t,n.lineWidth=1.5,n.beginPath(),n.moveTo(c,l-4),n.lineTo(c,l),n.lineTo(a,l),n.lineTo(a,l-4),n.stroke(),n.textAlign="right",z_(n,s===null?kf(o):`${kf(o)} \xB7 grid ${kf(s)}`,a,l-11,t,i)}function d1({from:n,along:e},t){let i=xt(e,e),s=xt(n,e),r=s*s-i*(xt(n,n)-t*t);if(!(r>=0))return null;let o=(-s-Math.sqrt(r))/i;return o>=0?o:null}function f1({from:n,along:e},t){let i=0,s=1/0;for(let r=0;r<3;++r){if(e[r]===0){if(Math.abs(n[r])>t[r])return null;continue}let o=(-Math.sign(e[r])*t[r]-n[r])/e[r],a=(Math.sign(e[r])*t[r]-n[r])/e[r];i=Math.max(i,o),s=Math.min(s,a)}return i<=s&&s>0?i:null}function G_(n,e,t,i){let s=null;for(let r of e.pieces){let{body:o}=r;if(t.hidden[o])continue;let a=t.turn(o),l=je(t.at(o),Yt(a,r.position)),c=qi(yr(a,r.orientation)),u={from:Yt(c,mt(n.from,l)),along:Yt(c,n.along)},f=-xt(u.from,u.along)/Math.hypot(...n.along),d=i(Math.max(f,0)),p=r.mold==="sphere"||Math.max(...r.half)<d?d1(u,Math.max(r.half[0],d)):f1(u,r.half.map(m=>Math.max(m,d)));p!==null&&(!s||p<s.s)&&(s={body:o,s:p})}return s&&{body:s.body,point:je(n.from,nt(n.along,s.s))}}var H_=.1;function Ya(n,e){let t=n*e,i=t+3,s={along:new Float64Array(i),first:new Float64Array(i),second:new Float64Array(i)};s.along[i-1]=1;for(let r=0;r<=t;++r){let o=2*Math.PI*r/e;s.along[r+1]=H_+(1-2*H_)*(r/t),s.first[r+1]=Math.cos(o),s.second[r+1]=Math.sin(o)}return s}function Nc(n,e,t,i,s,r,o){let a=[i[0]-t[0],i[1]-t[1],i[2]-t[2]],l=Math.hypot(a[0],a[1],a[2]),[c,u]=Ys(l>0?[a[0]/l,a[1]/l,a[2]/l]:[0,1,0]),[f,d,p]=t;for(let m=1;m<e.along.length;++m){let v=e.along[m],_=s*e.first[m],g=s*e.second[m],y=t[0]+v*a[0]+_*c[0]+g*u[0],E=t[1]+v*a[1]+_*c[1]+g*u[1],M=t[2]+v*a[2]+_*c[2]+g*u[2];n.put(f,d,p,y,E,M,r,o),[f,d,p]=[y,E,M]}}var kc=class{constructor(e,t){this.extent=t;let i=new Map(e.body.map((o,a)=>[o.name,a])),s=o=>o===void 0?-1:i.get(o)??-1,r=(o,a)=>{let l=e.body[o];return l?{body:o,point:Yt(qi(l.orientation),mt(a,l.position))}:{body:-1,point:a}};this.springs=e.spring.map(o=>{let a={body:s(o.body),point:o.anchor},l=o.to===void 0?{body:-1,point:o.pin??[0,0,0]}:{body:s(o.to),point:o.to_anchor??[0,0,0]};return{from:a,to:l,radius:Math.min(.012*t,o.rest_length>0?.15*o.rest_length:1/0)}}),this.joints=e.joint.map(o=>{let a=s(o.body),l=e.body[a]&&o.axis?Yt(qi(e.body[a].orientation),di(o.axis,[0,0,1])):[0,0,1];if(o.type==="distance"){let u=o.to===void 0?{body:-1,point:o.point??[0,0,0]}:{body:s(o.to),point:[0,0,0]};return{type:o.type,from:{body:a,point:[0,0,0]},to:u,axis:l}}let c=o.point??[0,0,0];return{type:o.type,from:r(a,c),to:r(s(o.to),c),axis:l}}),this.coil=this.springs.length<=200?Ya(8,10):Ya(4,4)}extent;springs;joints;coil;draw(e,t){let{ink:i,ground:s}=e.theme;for(let{from:r,to:o,radius:a}of this.springs)Fc(t,r)||Fc(t,o)||Nc(e.links,this.coil,Uc(t,r),Uc(t,o),a,Cs(i,s,.2),1.5);for(let r of this.joints)!Fc(t,r.from)&&!Fc(t,r.to)&&this.joint(e,t,r)}joint(e,t,{type:i,from:s,to:r,axis:o}){let{ink:a,ground:l}=e.theme,c=Cs(a,l,.35),[u,f]=[Uc(t,s),Uc(t,r)];if(i==="distance"){e.links.add(u,f,c,3),e.marks.dot(u,a,6),e.marks.dot(f,a,6);return}for(let[d,p]of[[s,u],[r,f]])d.body>=0&&Tt(d.point)>1e-9*this.extent&&e.links.add(t.at(d.body),p,c,1.5);if(e.marks.add(u,f,a,1,1,1),i==="fixed"){this.square(e,t,s,u);return}if(i==="hinge"){let d=nt(s.body>=0?Yt(t.turn(s.body),o):o,.06*this.extent);e.marks.add(mt(u,d),je(u,d),a,3)}for(let d of[u,f])e.marks.dot(d,a,10),e.marks.dot(d,l,5)}square({marks:e,theme:t},i,s,r){let o=.018*this.extent,a=s.body>=0?Yt(i.turn(s.body),[0,0,1]):[0,0,1],[l,c]=Ys(di(a,[0,0,1])),u=f=>je(r,je(nt(l,f&1?o:-o),nt(c,f&2?o:-o)));for(let[f,d]of[[0,1],[1,3],[3,2],[2,0],[0,3],[1,2]])e.add(u(f),u(d),t.ink,2)}},Fc=(n,e)=>e.body>=0&&n.hidden[e.body]===1;function Uc(n,e){return e.body<0?e.point:je(n.at(e.body),Yt(n.turn(e.body),e.point))}var Bo=class{data=new Float32Array(12*256);count=0;version=0;clear(){this.count=0,++this.version}add(e,t,i,s,r=s,o=0){this.put(e[0],e[1],e[2],t[0],t[1],t[2],i,s,r,o)}dot(e,t,i){this.add(e,e,t,i,i,2)}put(e,t,i,s,r,o,a,l,c=l,u=0){if((this.count+1)*12>this.data.length){let p=new Float32Array(2*this.data.length);p.set(this.data),this.data=p}let f=this.count*12,d=this.data;d[f]=e,d[f+1]=t,d[f+2]=i,d[f+3]=s,d[f+4]=r,d[f+5]=o,d[f+6]=a[0],d[f+7]=a[1],d[f+8]=a[2],d[f+9]=l,d[f+10]=c,d[f+11]=u,++this.count}};var W_={velocity:{width:2.5,pattern:0,heads:1},momentum:{width:4,pattern:1,heads:1},"angular momentum":{width:2.5,pattern:0,heads:2},impulse:{width:3.5,pattern:0,heads:1},normal:{width:1.5,pattern:1,heads:1}},p1=Ya(6,10);function Ja(n,e,t,i,s,r,o=1,a=0){let l=Tt(t);if(!(l>1e-6*r))return;let c=Math.min(.4/o,.035*r/l),u=d=>je(e,nt(t,d)),f=(3*s+5)*Math.min(1,l/(.07*r)+.25);n.add(e,u(1-o*c),i,s,s,a);for(let d=0;d<o;++d)n.add(u(1-(d+1)*c),u(1-d*c),i,f,0)}function $_(n,e){for(let{at:t,along:i,kind:s}of e){if(!ai(t)||!ai(i))continue;let{width:r,pattern:o,heads:a}=W_[s];Ja(n.marks,t,i,n.theme.arrows[s],r,n.extent,a,o)}}var m1=120;function X_(n,e,t){let{marks:i,theme:s,extent:r,typical:o}=n,a=Math.min(.016*r,.7*o),l=s.arrows.impulse;for(let{point:c,normal:u,impulse:f}of e){if(!ai(c)||!ai(u))continue;let d=di(u,[0,1,0]);e.length<=m1?g1(i,c,d,a,l):i.dot(c,l,4),f===null?Ja(i,c,nt(d,3*a),s.arrows.normal,1.5,r,1,1):Number.isFinite(f)&&t>0&&Ja(i,c,nt(d,.2*r*f/t),l,W_.impulse.width,r)}}function g1(n,e,t,i,s){let[r,o]=Ys(t),a=l=>je(e,je(nt(r,i*Math.cos(l)),nt(o,i*Math.sin(l))));for(let l=0;l<16;++l)n.add(a(Math.PI*l/8),a(Math.PI*(l+1)/8),s,1.5);for(let l of[.4,.8,1.2,1.6,2,2.4,2.8])n.add(a(l),a(-l),s,1)}function q_(n,e){for(let{from:t,to:i}of e)!ai(t)||!ai(i)||(Nc(n.marks,p1,t,i,.008*n.extent,n.theme.arrows.impulse,1.5),n.marks.dot(t,n.theme.arrows.impulse,8),n.marks.dot(i,n.theme.arrows.impulse,8))}function _1(n,e,t){let i=nt(je(t.min,t.max),.5),s=Tt(mt(t.max,t.min)),r=je(i,nt(n,e-xt(n,i))),[o,a]=Ys(n),l=[[-1,-1],[1,-1],[1,1],[-1,1]].map(([c,u])=>je(r,je(nt(o,c*s),nt(a,u*s))));for(let c=0;c<3;++c)for(let u of[1,-1]){let f=[0,0,0];f[c]=u,l=Y_(l,f,u>0?t.max[c]:-t.min[c])}return l}function Y_(n,e,t){return n.flatMap((i,s)=>{let r=n[(s+1)%n.length],[o,a]=[xt(i,e)-t,xt(r,e)-t],l=o*a<0?[je(i,nt(mt(r,i),o/(o-a)))]:[];return o<=0?[i,...l]:l})}function x1(n,e,t){let i=[];return n.forEach((s,r)=>{let o=n[(r+1)%n.length],[a,l]=[xt(s,e)-t,xt(o,e)-t];a<=0!=l<=0&&i.push(je(s,nt(mt(o,s),a/(a-l))))}),i.length>=2?[i[0],i[1]]:null}var Vf=n=>Pc(n/8),J_=(n,e)=>n.plane.map(t=>xt(t.normal,e)>=t.offset);function Z_(n,e,t,i,s){let r=Tt(mt(t.max,t.min)),o=.18*r,a={min:mt(t.min,[o,o,o]),max:je(t.max,[o,o,o])},l=Cs(i.ground,i.ink,.5);e.plane.forEach((c,u)=>{let f=di(c.normal,[0,1,0]),d=e.plane.reduce((g,y)=>y===c?g:Y_(g,nt(y.normal,-1),-y.offset),_1(f,c.offset,a));if(d.length<3)return;if(!s[u]){d.forEach((g,y)=>n.add(g,d[(y+1)%d.length],i.faint,1));return}let p=Vf(r);for(let g of Ys(f)){let y=d.map(M=>xt(M,g)),E=Math.floor(Math.max(...y)/p);for(let M=Math.ceil(Math.min(...y)/p);M<=E;++M){let I=x1(d,g,M*p);I&&n.add(I[0],I[1],i.faint,1)}}let m=.25*p;d.forEach((g,y)=>{let E=d[(y+1)%d.length];n.add(g,E,l,1);let M=mt(E,g),I=Math.floor(Tt(M)/(p/2)),C=je(nt(f,-m),nt(di(M,[0,0,0]),-m));for(let b=1;b<=I;++b){let A=je(g,nt(M,(b-.5)/I));n.add(A,je(A,C),l,1)}});let v=d.reduce((g,y)=>je(g,nt(y,1/d.length)),[0,0,0]),_=je(v,nt(mt(d[0],v),.8));Ja(n,_,nt(f,-.07*r),l,2,r)})}var wx=0,gp=1,Tx=2;var vl=1,Ax=2,ha=3,Lr=0,ui=1,ji=2,no=0,da=1,_p=2,xp=3,yp=4,Ex=5;var io=100,Cx=101,Rx=102,Px=103,Ix=104,Lx=200,Dx=201,Nx=202,Fx=203,vp=204,bp=205,Ux=206,kx=207,Ox=208,Bx=209,Vx=210,zx=211,Gx=212,Hx=213,Wx=214,uu=0,hu=1,du=2,na=3,fu=4,pu=5,mu=6,gu=7,Sp=0,$x=1,Xx=2,Fs=0,Mp=1,wp=2,Tp=3,Ap=4,Ep=5,Cp=6,Rp=7;var Pp=300,so=301,fa=302,$u=303,Xu=304,_u=1e3,Is=1001,xu=1002,Hn=1003,qx=1004;var bl=1005;var ci=1006,qu=1007;var ir=1008;var Fi=1009,Ip=1010,Lp=1011,pa=1012,Yu=1013,fs=1014,Ui=1015,ps=1016,Ju=1017,Zu=1018,ro=1020,Dp=35902,Np=35899,Fp=1021,Up=1022,ki=1023,tr=1026,sr=1027,kp=1028,Ku=1029,Dr=1030,ju=1031;var Qu=1033,Sl=33776,Ml=33777,wl=33778,Tl=33779,eh=35840,th=35841,nh=35842,ih=35843,sh=36196,rh=37492,oh=37496,ah=37488,lh=37489,Al=37490,ch=37491,uh=37808,hh=37809,dh=37810,fh=37811,ph=37812,mh=37813,gh=37814,_h=37815,xh=37816,yh=37817,vh=37818,bh=37819,Sh=37820,Mh=37821,wh=36492,Th=36494,Ah=36495,Eh=36283,Ch=36284,El=36285,Rh=36286;var nl=2300,yu=2301,lu=2302,up=2303,hp=2400,dp=2401,fp=2402;var Yx=3200;var Op=0,Jx=1,rr="",Ri="srgb",Zr="srgb-linear",il="linear",Ft="srgb";var cu=7680;var Zx=519,Kx=512,jx=513,Qx=514,Bp=515,ey=516,ty=517,Vp=518,zp=519,Gp=35044,oo=35048;var Cl="300 es",Zi=2e3,sl=2001;function y1(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function v1(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function rl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function ny(){let n=rl("canvas");return n.style.display="block",n}var K_={},ia=null;function ol(...n){let e="THREE."+n.shift();ia?ia("log",e,...n):console.log(e,...n)}function iy(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ke(...n){n=iy(n);let e="THREE."+n.shift();if(ia)ia("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function st(...n){n=iy(n);let e="THREE."+n.shift();if(ia)ia("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function tl(...n){let e=n.join(" ");e in K_||(K_[e]=!0,Ke(...n))}function sy(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var ry={[uu]:uu,[du]:mu,[fu]:fu,[na]:pu,[hu]:hu,[mu]:du,[gu]:gu,[pu]:na},Ls=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var zf=Math.PI/180,vu=180/Math.PI;function ao(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Zn[n&255]+Zn[n>>8&255]+Zn[n>>16&255]+Zn[n>>24&255]+"-"+Zn[e&255]+Zn[e>>8&255]+"-"+Zn[e>>16&15|64]+Zn[e>>24&255]+"-"+Zn[t&63|128]+Zn[t>>8&255]+"-"+Zn[t>>16&255]+Zn[t>>24&255]+Zn[i&255]+Zn[i>>8&255]+Zn[i>>16&255]+Zn[i>>24&255]).toLowerCase()}function dt(n,e,t){return Math.max(e,Math.min(t,n))}function b1(n,e){return(n%e+e)%e}function Gf(n,e,t){return(1-t)*n+t*e}function oy(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Ph(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function ay(n,e){if(e.constructor===Float32Array)return n;let t=Ph(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function ly(n,e){if(e.constructor===Float32Array)return n;let t=Ph(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Et=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=dt(this.x,e.x,t.x),this.y=dt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=dt(this.x,e,t),this.y=dt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(dt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(dt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ds=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],d=r[o+0],p=r[o+1],m=r[o+2],v=r[o+3];if(f!==v||l!==d||c!==p||u!==m){let _=l*d+c*p+u*m+f*v;_<0&&(d=-d,p=-p,m=-m,v=-v,_=-_);let g=1-a;if(_<.9995){let y=Math.acos(_),E=Math.sin(y);g=Math.sin(g*y)/E,a=Math.sin(a*y)/E,l=l*g+d*a,c=c*g+p*a,u=u*g+m*a,f=f*g+v*a}else{l=l*g+d*a,c=c*g+p*a,u=u*g+m*a,f=f*g+v*a;let y=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=y,c*=y,u*=y,f*=y}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],d=r[o+1],p=r[o+2],m=r[o+3];return e[t]=a*m+u*f+l*p-c*d,e[t+1]=l*m+u*d+c*f-a*p,e[t+2]=c*m+u*p+a*d-l*f,e[t+3]=u*m-a*f-l*d-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),d=l(i/2),p=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*u*f+c*p*m,this._y=c*p*f-d*u*m,this._z=c*u*m+d*p*f,this._w=c*u*f-d*p*m;break;case"YXZ":this._x=d*u*f+c*p*m,this._y=c*p*f-d*u*m,this._z=c*u*m-d*p*f,this._w=c*u*f+d*p*m;break;case"ZXY":this._x=d*u*f-c*p*m,this._y=c*p*f+d*u*m,this._z=c*u*m+d*p*f,this._w=c*u*f-d*p*m;break;case"ZYX":this._x=d*u*f-c*p*m,this._y=c*p*f+d*u*m,this._z=c*u*m-d*p*f,this._w=c*u*f+d*p*m;break;case"YZX":this._x=d*u*f+c*p*m,this._y=c*p*f+d*u*m,this._z=c*u*m-d*p*f,this._w=c*u*f-d*p*m;break;case"XZY":this._x=d*u*f-c*p*m,this._y=c*p*f-d*u*m,this._z=c*u*m+d*p*f,this._w=c*u*f+d*p*m;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],d=i+a+f;if(d>0){let p=.5/Math.sqrt(d+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>f){let p=2*Math.sqrt(1+i-a-f);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>f){let p=2*Math.sqrt(1+a-i-f);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+f-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(dt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(j_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(j_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=dt(this.x,e.x,t.x),this.y=dt(this.y,e.y,t.y),this.z=dt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=dt(this.x,e,t),this.y=dt(this.y,e,t),this.z=dt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(dt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Hf.copy(this).projectOnVector(e),this.sub(Hf)}reflect(e){return this.sub(Hf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(dt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Hf=new X,j_=new Ds,rt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],d=i[2],p=i[5],m=i[8],v=s[0],_=s[3],g=s[6],y=s[1],E=s[4],M=s[7],I=s[2],C=s[5],b=s[8];return r[0]=o*v+a*y+l*I,r[3]=o*_+a*E+l*C,r[6]=o*g+a*M+l*b,r[1]=c*v+u*y+f*I,r[4]=c*_+u*E+f*C,r[7]=c*g+u*M+f*b,r[2]=d*v+p*y+m*I,r[5]=d*_+p*E+m*C,r[8]=d*g+p*M+m*b,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,d=a*l-u*r,p=c*r-o*l,m=t*f+i*d+s*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/m;return e[0]=f*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=d*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=p*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return tl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Wf.makeScale(e,t)),this}rotate(e){return tl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Wf.makeRotation(-e)),this}translate(e,t){return tl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Wf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Wf=new rt,Q_=new rt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ex=new rt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function S1(){let n={enabled:!0,workingColorSpace:Zr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ft&&(s.r=er(s.r),s.g=er(s.g),s.b=er(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ft&&(s.r=ta(s.r),s.g=ta(s.g),s.b=ta(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===rr?il:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Zr]:{primaries:e,whitePoint:i,transfer:il,toXYZ:Q_,fromXYZ:ex,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Ri},outputColorSpaceConfig:{drawingBufferColorSpace:Ri}},[Ri]:{primaries:e,whitePoint:i,transfer:Ft,toXYZ:Q_,fromXYZ:ex,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Ri}}}),n}var bt=S1();function er(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ta(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Vo,bu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Vo===void 0&&(Vo=rl("canvas")),Vo.width=e.width,Vo.height=e.height;let s=Vo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Vo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=rl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=er(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(er(t[i]/255)*255):t[i]=er(t[i]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},M1=0,sa=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:M1++}),this.uuid=ao(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push($f(s[o].image)):r.push($f(s[o]))}else r=$f(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function $f(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?bu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var w1=0,Xf=new X,pi=class n extends Ls{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Is,s=Is,r=ci,o=ir,a=ki,l=Fi,c=n.DEFAULT_ANISOTROPY,u=rr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:w1++}),this.uuid=ao(),this.name="",this.source=new sa(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Et(0,0),this.repeat=new Et(1,1),this.center=new Et(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new rt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Xf).x}get height(){return this.source.getSize(Xf).y}get depth(){return this.source.getSize(Xf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Pp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case _u:e.x=e.x-Math.floor(e.x);break;case Is:e.x=e.x<0?0:1;break;case xu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case _u:e.y=e.y-Math.floor(e.y);break;case Is:e.y=e.y<0?0:1;break;case xu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};pi.DEFAULT_IMAGE=null;pi.DEFAULT_MAPPING=Pp;pi.DEFAULT_ANISOTROPY=1;var an=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],d=l[1],p=l[5],m=l[9],v=l[2],_=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(f-v)<.01&&Math.abs(m-_)<.01){if(Math.abs(u+d)<.1&&Math.abs(f+v)<.1&&Math.abs(m+_)<.1&&Math.abs(c+p+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,M=(p+1)/2,I=(g+1)/2,C=(u+d)/4,b=(f+v)/4,A=(m+_)/4;return E>M&&E>I?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=C/i,r=b/i):M>I?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=C/s,r=A/s):I<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),i=b/r,s=A/r),this.set(i,s,r,t),this}let y=Math.sqrt((_-m)*(_-m)+(f-v)*(f-v)+(d-u)*(d-u));return Math.abs(y)<.001&&(y=1),this.x=(_-m)/y,this.y=(f-v)/y,this.z=(d-u)/y,this.w=Math.acos((c+p+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=dt(this.x,e.x,t.x),this.y=dt(this.y,e.y,t.y),this.z=dt(this.z,e.z,t.z),this.w=dt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=dt(this.x,e,t),this.y=dt(this.y,e,t),this.z=dt(this.z,e,t),this.w=dt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(dt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Su=class extends Ls{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ci,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new an(0,0,e,t),this.scissorTest=!1,this.viewport=new an(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new pi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ci,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new sa(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Li=class extends Su{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},al=class extends pi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Hn,this.minFilter=Hn,this.wrapR=Is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Mu=class extends pi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Hn,this.minFilter=Hn,this.wrapR=Is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Jt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,d,p,m,v,_){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,d,p,m,v,_)}set(e,t,i,s,r,o,a,l,c,u,f,d,p,m,v,_){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=f,g[14]=d,g[3]=p,g[7]=m,g[11]=v,g[15]=_,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/zo.setFromMatrixColumn(e,0).length(),r=1/zo.setFromMatrixColumn(e,1).length(),o=1/zo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let d=o*u,p=o*f,m=a*u,v=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=p+m*c,t[5]=d-v*c,t[9]=-a*l,t[2]=v-d*c,t[6]=m+p*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,p=l*f,m=c*u,v=c*f;t[0]=d+v*a,t[4]=m*a-p,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=p*a-m,t[6]=v+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,p=l*f,m=c*u,v=c*f;t[0]=d-v*a,t[4]=-o*f,t[8]=m+p*a,t[1]=p+m*a,t[5]=o*u,t[9]=v-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,p=o*f,m=a*u,v=a*f;t[0]=l*u,t[4]=m*c-p,t[8]=d*c+v,t[1]=l*f,t[5]=v*c+d,t[9]=p*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,p=o*c,m=a*l,v=a*c;t[0]=l*u,t[4]=v-d*f,t[8]=m*f+p,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*f+m,t[10]=d-v*f}else if(e.order==="XZY"){let d=o*l,p=o*c,m=a*l,v=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=d*f+v,t[5]=o*u,t[9]=p*f-m,t[2]=m*f-p,t[6]=a*u,t[10]=v*f+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(T1,e,A1)}lookAt(e,t,i){let s=this.elements;return Ei.subVectors(e,t),Ei.lengthSq()===0&&(Ei.z=1),Ei.normalize(),vr.crossVectors(i,Ei),vr.lengthSq()===0&&(Math.abs(i.z)===1?Ei.x+=1e-4:Ei.z+=1e-4,Ei.normalize(),vr.crossVectors(i,Ei)),vr.normalize(),Bc.crossVectors(Ei,vr),s[0]=vr.x,s[4]=Bc.x,s[8]=Ei.x,s[1]=vr.y,s[5]=Bc.y,s[9]=Ei.y,s[2]=vr.z,s[6]=Bc.z,s[10]=Ei.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],d=i[9],p=i[13],m=i[2],v=i[6],_=i[10],g=i[14],y=i[3],E=i[7],M=i[11],I=i[15],C=s[0],b=s[4],A=s[8],H=s[12],F=s[1],D=s[5],G=s[9],V=s[13],N=s[2],W=s[6],Z=s[10],z=s[14],ue=s[3],K=s[7],Q=s[11],re=s[15];return r[0]=o*C+a*F+l*N+c*ue,r[4]=o*b+a*D+l*W+c*K,r[8]=o*A+a*G+l*Z+c*Q,r[12]=o*H+a*V+l*z+c*re,r[1]=u*C+f*F+d*N+p*ue,r[5]=u*b+f*D+d*W+p*K,r[9]=u*A+f*G+d*Z+p*Q,r[13]=u*H+f*V+d*z+p*re,r[2]=m*C+v*F+_*N+g*ue,r[6]=m*b+v*D+_*W+g*K,r[10]=m*A+v*G+_*Z+g*Q,r[14]=m*H+v*V+_*z+g*re,r[3]=y*C+E*F+M*N+I*ue,r[7]=y*b+E*D+M*W+I*K,r[11]=y*A+E*G+M*Z+I*Q,r[15]=y*H+E*V+M*z+I*re,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],d=e[10],p=e[14],m=e[3],v=e[7],_=e[11],g=e[15],y=l*p-c*d,E=a*p-c*f,M=a*d-l*f,I=o*p-c*u,C=o*d-l*u,b=o*f-a*u;return t*(v*y-_*E+g*M)-i*(m*y-_*I+g*C)+s*(m*E-v*I+g*b)-r*(m*M-v*C+_*b)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],d=e[10],p=e[11],m=e[12],v=e[13],_=e[14],g=e[15],y=t*a-i*o,E=t*l-s*o,M=t*c-r*o,I=i*l-s*a,C=i*c-r*a,b=s*c-r*l,A=u*v-f*m,H=u*_-d*m,F=u*g-p*m,D=f*_-d*v,G=f*g-p*v,V=d*g-p*_,N=y*V-E*G+M*D+I*F-C*H+b*A;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*V-l*G+c*D)*W,e[1]=(s*G-i*V-r*D)*W,e[2]=(v*b-_*C+g*I)*W,e[3]=(d*C-f*b-p*I)*W,e[4]=(l*F-o*V-c*H)*W,e[5]=(t*V-s*F+r*H)*W,e[6]=(_*M-m*b-g*E)*W,e[7]=(u*b-d*M+p*E)*W,e[8]=(o*G-a*F+c*A)*W,e[9]=(i*F-t*G-r*A)*W,e[10]=(m*C-v*M+g*y)*W,e[11]=(f*M-u*C-p*y)*W,e[12]=(a*H-o*D-l*A)*W,e[13]=(t*D-i*H+s*A)*W,e[14]=(v*E-m*I-_*y)*W,e[15]=(u*I-f*E+d*y)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,d=r*c,p=r*u,m=r*f,v=o*u,_=o*f,g=a*f,y=l*c,E=l*u,M=l*f,I=i.x,C=i.y,b=i.z;return s[0]=(1-(v+g))*I,s[1]=(p+M)*I,s[2]=(m-E)*I,s[3]=0,s[4]=(p-M)*C,s[5]=(1-(d+g))*C,s[6]=(_+y)*C,s[7]=0,s[8]=(m+E)*b,s[9]=(_-y)*b,s[10]=(1-(d+v))*b,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=zo.set(s[0],s[1],s[2]).length(),a=zo.set(s[4],s[5],s[6]).length(),l=zo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),us.copy(this);let c=1/o,u=1/a,f=1/l;return us.elements[0]*=c,us.elements[1]*=c,us.elements[2]*=c,us.elements[4]*=u,us.elements[5]*=u,us.elements[6]*=u,us.elements[8]*=f,us.elements[9]*=f,us.elements[10]*=f,t.setFromRotationMatrix(us),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Zi,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),d=(t+e)/(t-e),p=(i+s)/(i-s),m,v;if(l)m=r/(o-r),v=o*r/(o-r);else if(a===Zi)m=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===sl)m=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=f,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Zi,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),d=-(t+e)/(t-e),p=-(i+s)/(i-s),m,v;if(l)m=1/(o-r),v=o/(o-r);else if(a===Zi)m=-2/(o-r),v=-(o+r)/(o-r);else if(a===sl)m=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=f,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},zo=new X,us=new Jt,T1=new X(0,0,0),A1=new X(1,1,1),vr=new X,Bc=new X,Ei=new X,tx=new Jt,nx=new Ds,Tr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],d=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(dt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-dt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(dt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-dt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(dt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-dt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return tx.makeRotationFromQuaternion(e),this.setFromRotationMatrix(tx,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return nx.setFromEuler(this),this.setFromQuaternion(nx,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Tr.DEFAULT_ORDER="XYZ";var ll=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},E1=0,ix=new X,Go=new Ds,Js=new Jt,Vc=new X,Za=new X,C1=new X,R1=new Ds,sx=new X(1,0,0),rx=new X(0,1,0),ox=new X(0,0,1),ax={type:"added"},P1={type:"removed"},Ho={type:"childadded",child:null},qf={type:"childremoved",child:null},Di=class n extends Ls{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:E1++}),this.uuid=ao(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new X,t=new Tr,i=new Ds,s=new X(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Jt},normalMatrix:{value:new rt}}),this.matrix=new Jt,this.matrixWorld=new Jt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ll,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Go.setFromAxisAngle(e,t),this.quaternion.multiply(Go),this}rotateOnWorldAxis(e,t){return Go.setFromAxisAngle(e,t),this.quaternion.premultiply(Go),this}rotateX(e){return this.rotateOnAxis(sx,e)}rotateY(e){return this.rotateOnAxis(rx,e)}rotateZ(e){return this.rotateOnAxis(ox,e)}translateOnAxis(e,t){return ix.copy(e).applyQuaternion(this.quaternion),this.position.add(ix.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(sx,e)}translateY(e){return this.translateOnAxis(rx,e)}translateZ(e){return this.translateOnAxis(ox,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Js.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Vc.copy(e):Vc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Za.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Js.lookAt(Za,Vc,this.up):Js.lookAt(Vc,Za,this.up),this.quaternion.setFromRotationMatrix(Js),s&&(Js.extractRotation(s.matrixWorld),Go.setFromRotationMatrix(Js),this.quaternion.premultiply(Go.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(st("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ax),Ho.child=e,this.dispatchEvent(Ho),Ho.child=null):st("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(P1),qf.child=e,this.dispatchEvent(qf),qf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Js.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Js.multiply(e.parent.matrixWorld)),e.applyMatrix4(Js),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ax),Ho.child=e,this.dispatchEvent(Ho),Ho.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Za,e,C1),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Za,R1,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),d=o(e.skeletons),p=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),d.length>0&&(i.skeletons=d),p.length>0&&(i.animations=p),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Di.DEFAULT_UP=new X(0,1,0);Di.DEFAULT_MATRIX_AUTO_UPDATE=!0;Di.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Jr=class extends Di{constructor(){super(),this.isGroup=!0,this.type="Group"}},I1={type:"move"},ra=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Jr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Jr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Jr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let _=t.getJointPose(v,i),g=this._getHandJoint(c,v);_!==null&&(g.matrix.fromArray(_.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=_.radius),g.visible=_!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],d=u.position.distanceTo(f.position),p=.02,m=.005;c.inputState.pinching&&d>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(I1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Jr;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},cy={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},br={h:0,s:0,l:0},zc={h:0,s:0,l:0};function Yf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Ct=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Ri){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,bt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=bt.workingColorSpace){return this.r=e,this.g=t,this.b=i,bt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=bt.workingColorSpace){if(e=b1(e,1),t=dt(t,0,1),i=dt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Yf(o,r,e+1/3),this.g=Yf(o,r,e),this.b=Yf(o,r,e-1/3)}return bt.colorSpaceToWorking(this,s),this}setStyle(e,t=Ri){function i(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Ri){let i=cy[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=er(e.r),this.g=er(e.g),this.b=er(e.b),this}copyLinearToSRGB(e){return this.r=ta(e.r),this.g=ta(e.g),this.b=ta(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Ri){return bt.workingToColorSpace(Kn.copy(this),e),Math.round(dt(Kn.r*255,0,255))*65536+Math.round(dt(Kn.g*255,0,255))*256+Math.round(dt(Kn.b*255,0,255))}getHexString(e=Ri){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=bt.workingColorSpace){bt.workingToColorSpace(Kn.copy(this),t);let i=Kn.r,s=Kn.g,r=Kn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=bt.workingColorSpace){return bt.workingToColorSpace(Kn.copy(this),t),e.r=Kn.r,e.g=Kn.g,e.b=Kn.b,e}getStyle(e=Ri){bt.workingToColorSpace(Kn.copy(this),e);let t=Kn.r,i=Kn.g,s=Kn.b;return e!==Ri?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(br),this.setHSL(br.h+e,br.s+t,br.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(br),e.getHSL(zc);let i=Gf(br.h,zc.h,t),s=Gf(br.s,zc.s,t),r=Gf(br.l,zc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Kn=new Ct;Ct.NAMES=cy;var cl=class extends Di{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Tr,this.environmentIntensity=1,this.environmentRotation=new Tr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},hs=new X,Zs=new X,Jf=new X,Ks=new X,Wo=new X,$o=new X,lx=new X,Zf=new X,Kf=new X,jf=new X,Qf=new an,ep=new an,tp=new an,Ps=class n{constructor(e=new X,t=new X,i=new X){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),hs.subVectors(e,t),s.cross(hs);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){hs.subVectors(s,t),Zs.subVectors(i,t),Jf.subVectors(e,t);let o=hs.dot(hs),a=hs.dot(Zs),l=hs.dot(Jf),c=Zs.dot(Zs),u=Zs.dot(Jf),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let d=1/f,p=(c*l-a*u)*d,m=(o*u-a*l)*d;return r.set(1-p-m,m,p)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ks)===null?!1:Ks.x>=0&&Ks.y>=0&&Ks.x+Ks.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ks)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ks.x),l.addScaledVector(o,Ks.y),l.addScaledVector(a,Ks.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Qf.setScalar(0),ep.setScalar(0),tp.setScalar(0),Qf.fromBufferAttribute(e,t),ep.fromBufferAttribute(e,i),tp.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Qf,r.x),o.addScaledVector(ep,r.y),o.addScaledVector(tp,r.z),o}static isFrontFacing(e,t,i,s){return hs.subVectors(i,t),Zs.subVectors(e,t),hs.cross(Zs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return hs.subVectors(this.c,this.b),Zs.subVectors(this.a,this.b),hs.cross(Zs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Wo.subVectors(s,i),$o.subVectors(r,i),Zf.subVectors(e,i);let l=Wo.dot(Zf),c=$o.dot(Zf);if(l<=0&&c<=0)return t.copy(i);Kf.subVectors(e,s);let u=Wo.dot(Kf),f=$o.dot(Kf);if(u>=0&&f<=u)return t.copy(s);let d=l*f-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Wo,o);jf.subVectors(e,r);let p=Wo.dot(jf),m=$o.dot(jf);if(m>=0&&p<=m)return t.copy(r);let v=p*c-l*m;if(v<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector($o,a);let _=u*m-p*f;if(_<=0&&f-u>=0&&p-m>=0)return lx.subVectors(r,s),a=(f-u)/(f-u+(p-m)),t.copy(s).addScaledVector(lx,a);let g=1/(_+v+d);return o=v*g,a=d*g,t.copy(i).addScaledVector(Wo,o).addScaledVector($o,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ar=class{constructor(e=new X(1/0,1/0,1/0),t=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(ds.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(ds.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=ds.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ds):ds.fromBufferAttribute(r,o),ds.applyMatrix4(e.matrixWorld),this.expandByPoint(ds);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Gc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Gc.copy(i.boundingBox)),Gc.applyMatrix4(e.matrixWorld),this.union(Gc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ds),ds.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ka),Hc.subVectors(this.max,Ka),Xo.subVectors(e.a,Ka),qo.subVectors(e.b,Ka),Yo.subVectors(e.c,Ka),Sr.subVectors(qo,Xo),Mr.subVectors(Yo,qo),$r.subVectors(Xo,Yo);let t=[0,-Sr.z,Sr.y,0,-Mr.z,Mr.y,0,-$r.z,$r.y,Sr.z,0,-Sr.x,Mr.z,0,-Mr.x,$r.z,0,-$r.x,-Sr.y,Sr.x,0,-Mr.y,Mr.x,0,-$r.y,$r.x,0];return!np(t,Xo,qo,Yo,Hc)||(t=[1,0,0,0,1,0,0,0,1],!np(t,Xo,qo,Yo,Hc))?!1:(Wc.crossVectors(Sr,Mr),t=[Wc.x,Wc.y,Wc.z],np(t,Xo,qo,Yo,Hc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ds).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ds).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(js[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),js[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),js[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),js[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),js[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),js[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),js[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),js[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(js),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},js=[new X,new X,new X,new X,new X,new X,new X,new X],ds=new X,Gc=new Ar,Xo=new X,qo=new X,Yo=new X,Sr=new X,Mr=new X,$r=new X,Ka=new X,Hc=new X,Wc=new X,Xr=new X;function np(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Xr.fromArray(n,r);let a=s.x*Math.abs(Xr.x)+s.y*Math.abs(Xr.y)+s.z*Math.abs(Xr.z),l=e.dot(Xr),c=t.dot(Xr),u=i.dot(Xr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Cn=new X,$c=new Et,L1=0,fn=class extends Ls{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:L1++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Gp,this.updateRanges=[],this.gpuType=Ui,this.version=0,this._normalizationScale=e!==void 0?Ph(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)$c.fromBufferAttribute(this,t),$c.applyMatrix3(e),this.setXY(t,$c.x,$c.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Cn.fromBufferAttribute(this,t),Cn.applyMatrix3(e),this.setXYZ(t,Cn.x,Cn.y,Cn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Cn.fromBufferAttribute(this,t),Cn.applyMatrix4(e),this.setXYZ(t,Cn.x,Cn.y,Cn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Cn.fromBufferAttribute(this,t),Cn.applyNormalMatrix(e),this.setXYZ(t,Cn.x,Cn.y,Cn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Cn.fromBufferAttribute(this,t),Cn.transformDirection(e),this.setXYZ(t,Cn.x,Cn.y,Cn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):ay(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):ly(e,this.array)}};var ul=class extends fn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var hl=class extends fn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var fi=class extends fn{constructor(e,t,i){super(new Float32Array(e),t,i)}},D1=new Ar,ja=new X,ip=new X,Kr=class{constructor(e=new X,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):D1.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ja.subVectors(e,this.center);let t=ja.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ja,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ip.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ja.copy(e.center).add(ip)),this.expandByPoint(ja.copy(e.center).sub(ip))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},N1=0,Ji=new Jt,sp=new Di,Jo=new X,Ci=new Ar,Qa=new Ar,Gn=new X,Ki=class n extends Ls{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:N1++}),this.uuid=ao(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(y1(e)?hl:ul)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new rt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ji.makeRotationFromQuaternion(e),this.applyMatrix4(Ji),this}rotateX(e){return Ji.makeRotationX(e),this.applyMatrix4(Ji),this}rotateY(e){return Ji.makeRotationY(e),this.applyMatrix4(Ji),this}rotateZ(e){return Ji.makeRotationZ(e),this.applyMatrix4(Ji),this}translate(e,t,i){return Ji.makeTranslation(e,t,i),this.applyMatrix4(Ji),this}scale(e,t,i){return Ji.makeScale(e,t,i),this.applyMatrix4(Ji),this}lookAt(e){return sp.lookAt(e),sp.updateMatrix(),this.applyMatrix4(sp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Jo).negate(),this.translate(Jo.x,Jo.y,Jo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new fi(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ar);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Ci.setFromBufferAttribute(r),this.morphTargetsRelative?(Gn.addVectors(this.boundingBox.min,Ci.min),this.boundingBox.expandByPoint(Gn),Gn.addVectors(this.boundingBox.max,Ci.max),this.boundingBox.expandByPoint(Gn)):(this.boundingBox.expandByPoint(Ci.min),this.boundingBox.expandByPoint(Ci.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&st('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Kr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(e){let i=this.boundingSphere.center;if(Ci.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Qa.setFromBufferAttribute(a),this.morphTargetsRelative?(Gn.addVectors(Ci.min,Qa.min),Ci.expandByPoint(Gn),Gn.addVectors(Ci.max,Qa.max),Ci.expandByPoint(Gn)):(Ci.expandByPoint(Qa.min),Ci.expandByPoint(Qa.max))}Ci.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Gn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Gn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Gn.fromBufferAttribute(a,c),l&&(Jo.fromBufferAttribute(e,c),Gn.add(Jo)),s=Math.max(s,i.distanceToSquared(Gn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&st('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){st("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new fn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let H=0;H<i.count;H++)a[H]=new X,l[H]=new X;let u=new X,f=new X,d=new X,p=new Et,m=new Et,v=new Et,_=new X,g=new X;function y(H,F,D){c[H]=c[F]=c[D]=1,u.fromBufferAttribute(i,H),f.fromBufferAttribute(i,F),d.fromBufferAttribute(i,D),p.fromBufferAttribute(r,H),m.fromBufferAttribute(r,F),v.fromBufferAttribute(r,D),f.sub(u),d.sub(u),m.sub(p),v.sub(p);let G=1/(m.x*v.y-v.x*m.y);isFinite(G)&&(_.copy(f).multiplyScalar(v.y).addScaledVector(d,-m.y).multiplyScalar(G),g.copy(d).multiplyScalar(m.x).addScaledVector(f,-v.x).multiplyScalar(G),a[H].add(_),a[F].add(_),a[D].add(_),l[H].add(g),l[F].add(g),l[D].add(g))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let H=0,F=E.length;H<F;++H){let D=E[H],G=D.start,V=D.count;for(let N=G,W=G+V;N<W;N+=3)y(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let M=new X,I=new X,C=new X,b=new X;function A(H){C.fromBufferAttribute(s,H),b.copy(C);let F=a[H];M.copy(F),M.sub(C.multiplyScalar(C.dot(F))).normalize(),I.crossVectors(b,F);let G=I.dot(l[H])<0?-1:1;o.setXYZW(H,M.x,M.y,M.z,G)}for(let H=0,F=i.count;H<F;++H)c[H]&&A(H);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new fn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,p=i.count;d<p;d++)i.setXYZ(d,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,u=new X,f=new X;if(e)for(let d=0,p=e.count;d<p;d+=3){let m=e.getX(d+0),v=e.getX(d+1),_=e.getX(d+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,_),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,_),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(_,c.x,c.y,c.z)}else for(let d=0,p=t.count;d<p;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Gn.fromBufferAttribute(e,t),Gn.normalize(),e.setXYZ(t,Gn.x,Gn.y,Gn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,d=new c.constructor(l.length*u),p=0,m=0;for(let v=0,_=l.length;v<_;v++){a.isInterleavedBufferAttribute?p=l[v]*a.data.stride+a.offset:p=l[v]*u;for(let g=0;g<u;g++)d[m++]=c[p++]}return new fn(d,u,f)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let d=c[u],p=e(d,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,d=c.length;f<d;f++){let p=c[f];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let d=0,p=f.length;d<p;d++)u.push(f[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},wu=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Gp,this.updateRanges=[],this.version=0,this.uuid=ao()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=cx(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=cx(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function cx(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=ao()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var li=new X,jr=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?Ph(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)li.fromBufferAttribute(this,t),li.applyMatrix4(e),this.setXYZ(t,li.x,li.y,li.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)li.fromBufferAttribute(this,t),li.applyNormalMatrix(e),this.setXYZ(t,li.x,li.y,li.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)li.fromBufferAttribute(this,t),li.transformDirection(e),this.setXYZ(t,li.x,li.y,li.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){ol("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new fn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){ol("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):ay(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):ly(e,this.data.array)}},rp=new X,F1=new X,U1=new rt,Pi=class{constructor(e=new X(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=rp.subVectors(i,t).cross(F1.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(rp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||U1.getNormalMatrix(e),s=this.coplanarPoint(rp).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},k1=0,Er=class extends Ls{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:k1++}),this.uuid=ao(),this.name="",this.type="Material",this.blending=da,this.side=Lr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=vp,this.blendDst=bp,this.blendEquation=io,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ct(0,0,0),this.blendAlpha=0,this.depthFunc=na,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Zx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=cu,this.stencilZFail=cu,this.stencilZPass=cu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ct().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Pi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Et().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Et().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Qs=new X,op=new X,Xc=new X,qc=new X,dl=class{constructor(e=new X,t=new X(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Qs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Qs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Qs.copy(this.origin).addScaledVector(this.direction,t),Qs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){op.copy(e).add(t).multiplyScalar(.5),Xc.copy(t).sub(e).normalize(),qc.copy(this.origin).sub(op);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Xc),a=qc.dot(this.direction),l=-qc.dot(Xc),c=qc.lengthSq(),u=Math.abs(1-o*o),f,d,p,m;if(u>0)if(f=o*l-a,d=o*a-l,m=r*u,f>=0)if(d>=-m)if(d<=m){let v=1/u;f*=v,d*=v,p=f*(f+o*d+2*a)+d*(o*f+d+2*l)+c}else d=r,f=Math.max(0,-(o*d+a)),p=-f*f+d*(d+2*l)+c;else d=-r,f=Math.max(0,-(o*d+a)),p=-f*f+d*(d+2*l)+c;else d<=-m?(f=Math.max(0,-(-o*r+a)),d=f>0?-r:Math.min(Math.max(-r,-l),r),p=-f*f+d*(d+2*l)+c):d<=m?(f=0,d=Math.min(Math.max(-r,-l),r),p=d*(d+2*l)+c):(f=Math.max(0,-(o*r+a)),d=f>0?r:Math.min(Math.max(-r,-l),r),p=-f*f+d*(d+2*l)+c);else d=o>0?-r:r,f=Math.max(0,-(o*d+a)),p=-f*f+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(op).addScaledVector(Xc,d),p}intersectSphere(e,t){if(e.radius<0)return null;Qs.subVectors(e.center,this.origin);let i=Qs.dot(this.direction),s=Qs.dot(Qs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-d.z)*f,l=(e.max.z-d.z)*f):(a=(e.max.z-d.z)*f,l=(e.min.z-d.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Qs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,d=e.y-o.y,p=e.z-o.z,m=t.x-o.x,v=t.y-o.y,_=t.z-o.z,g=i.x-o.x,y=i.y-o.y,E=i.z-o.z,M=Math.abs(l),I=Math.abs(c),C=Math.abs(u),b,A,H,F,D,G,V,N,W,Z,z,ue;if(M>=I&&M>=C?(H=l,G=f,W=m,ue=g,l>=0?(b=c,A=u,F=d,D=p,V=v,N=_,Z=y,z=E):(b=u,A=c,F=p,D=d,V=_,N=v,Z=E,z=y)):I>=C?(H=c,G=d,W=v,ue=y,c>=0?(b=u,A=l,F=p,D=f,V=_,N=m,Z=E,z=g):(b=l,A=u,F=f,D=p,V=m,N=_,Z=g,z=E)):(H=u,G=p,W=_,ue=E,u>=0?(b=l,A=c,F=f,D=d,V=m,N=v,Z=g,z=y):(b=c,A=l,F=d,D=f,V=v,N=m,Z=y,z=g)),H===0)return null;let K=b/H,Q=A/H,re=1/H,fe=F-K*G,de=D-Q*G,ee=V-K*W,ge=N-Q*W,ye=Z-K*ue,Ce=z-Q*ue,Me=ye*ge-Ce*ee,Xe=fe*Ce-de*ye,ct=ee*de-ge*fe;if(s){if(Me<0||Xe<0||ct<0)return null}else if((Me<0||Xe<0||ct<0)&&(Me>0||Xe>0||ct>0))return null;let We=Me+Xe+ct;if(We===0)return null;let _t=re*(Me*G+Xe*W+ct*ue);return(We>0?_t<0:_t>0)?null:this.at(_t/We,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Tu=class extends Er{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Tr,this.combine=Sp,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},ux=new Jt,qr=new dl,Yc=new Kr,hx=new X,Jc=new X,Zc=new X,Kc=new X,ap=new X,jc=new X,dx=new X,Qc=new X,Xn=class extends Di{constructor(e=new Ki,t=new Tu){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){jc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(ap.fromBufferAttribute(f,e),o?jc.addScaledVector(ap,u):jc.addScaledVector(ap.sub(t),u))}t.add(jc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Yc.copy(i.boundingSphere),Yc.applyMatrix4(r),qr.copy(e.ray).recast(e.near),!(Yc.containsPoint(qr.origin)===!1&&(qr.intersectSphere(Yc,hx)===null||qr.origin.distanceToSquared(hx)>(e.far-e.near)**2))&&(ux.copy(r).invert(),qr.copy(e.ray).applyMatrix4(ux),!(i.boundingBox!==null&&qr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,qr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,d=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,v=d.length;m<v;m++){let _=d[m],g=o[_.materialIndex],y=Math.max(_.start,p.start),E=Math.min(a.count,Math.min(_.start+_.count,p.start+p.count));for(let M=y,I=E;M<I;M+=3){let C=a.getX(M),b=a.getX(M+1),A=a.getX(M+2);s=eu(this,g,e,i,c,u,f,C,b,A),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let m=Math.max(0,p.start),v=Math.min(a.count,p.start+p.count);for(let _=m,g=v;_<g;_+=3){let y=a.getX(_),E=a.getX(_+1),M=a.getX(_+2);s=eu(this,o,e,i,c,u,f,y,E,M),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,v=d.length;m<v;m++){let _=d[m],g=o[_.materialIndex],y=Math.max(_.start,p.start),E=Math.min(l.count,Math.min(_.start+_.count,p.start+p.count));for(let M=y,I=E;M<I;M+=3){let C=M,b=M+1,A=M+2;s=eu(this,g,e,i,c,u,f,C,b,A),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let m=Math.max(0,p.start),v=Math.min(l.count,p.start+p.count);for(let _=m,g=v;_<g;_+=3){let y=_,E=_+1,M=_+2;s=eu(this,o,e,i,c,u,f,y,E,M),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}}};function O1(n,e,t,i,s,r,o,a){let l;if(e.side===ui?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Lr,a),l===null)return null;Qc.copy(a),Qc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Qc);return c<t.near||c>t.far?null:{distance:c,point:Qc.clone(),object:n}}function eu(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Jc),n.getVertexPosition(l,Zc),n.getVertexPosition(c,Kc);let u=O1(n,e,t,i,Jc,Zc,Kc,dx);if(u){let f=new X;Ps.getBarycoord(dx,Jc,Zc,Kc,f),s&&(u.uv=Ps.getInterpolatedAttribute(s,a,l,c,f,new Et)),r&&(u.uv1=Ps.getInterpolatedAttribute(r,a,l,c,f,new Et)),o&&(u.normal=Ps.getInterpolatedAttribute(o,a,l,c,f,new X),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new X,materialIndex:0};Ps.getNormal(Jc,Zc,Kc,d.normal),u.face=d,u.barycoord=f}return u}var oa=class extends pi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Hn,u=Hn,f,d){super(null,o,a,l,c,u,s,r,f,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Cr=class extends fn{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var Yr=new Kr,B1=new Et(.5,.5),tu=new X,Qr=class{constructor(e=new Pi,t=new Pi,i=new Pi,s=new Pi,r=new Pi,o=new Pi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Zi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],d=r[6],p=r[7],m=r[8],v=r[9],_=r[10],g=r[11],y=r[12],E=r[13],M=r[14],I=r[15];if(s[0].setComponents(c-o,p-u,g-m,I-y).normalize(),s[1].setComponents(c+o,p+u,g+m,I+y).normalize(),s[2].setComponents(c+a,p+f,g+v,I+E).normalize(),s[3].setComponents(c-a,p-f,g-v,I-E).normalize(),i)s[4].setComponents(l,d,_,M).normalize(),s[5].setComponents(c-l,p-d,g-_,I-M).normalize();else if(s[4].setComponents(c-l,p-d,g-_,I-M).normalize(),t===Zi)s[5].setComponents(c+l,p+d,g+_,I+M).normalize();else if(t===sl)s[5].setComponents(l,d,_,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Yr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Yr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Yr)}intersectsSprite(e){Yr.center.set(0,0,0);let t=B1.distanceTo(e.center);return Yr.radius=.7071067811865476+t,Yr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Yr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(tu.x=s.normal.x>0?e.max.x:e.min.x,tu.y=s.normal.y>0?e.max.y:e.min.y,tu.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(tu)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},fx=new Jt,Au=class n{constructor(){this.coordinateSystem=Zi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];fx.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Qr),i[s].setFromProjectionMatrix(fx,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Qr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Eu=class extends Er{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ct(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Cu=new X,Ru=new X,px=new Jt,el=new dl,nu=new Kr,lp=new X,mx=new X,Pu=class extends Di{constructor(e=new Ki,t=new Eu){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Cu.fromBufferAttribute(t,s-1),Ru.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Cu.distanceTo(Ru);e.setAttribute("lineDistance",new fi(i,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),nu.copy(i.boundingSphere),nu.applyMatrix4(s),nu.radius+=r,e.ray.intersectsSphere(nu)===!1)return;px.copy(s).invert(),el.copy(e.ray).applyMatrix4(px);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let v=p,_=m-1;v<_;v+=c){let g=u.getX(v),y=u.getX(v+1),E=iu(this,e,el,l,g,y,v);E&&t.push(E)}if(this.isLineLoop){let v=u.getX(m-1),_=u.getX(p),g=iu(this,e,el,l,v,_,m-1);g&&t.push(g)}}else{let p=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let v=p,_=m-1;v<_;v+=c){let g=iu(this,e,el,l,v,v+1,v);g&&t.push(g)}if(this.isLineLoop){let v=iu(this,e,el,l,m-1,p,m-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function iu(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Cu.fromBufferAttribute(a,s),Ru.fromBufferAttribute(a,r),t.distanceSqToSegment(Cu,Ru,lp,mx)>i)return;lp.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(lp);if(!(c<e.near||c>e.far))return{distance:c,point:mx.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var gx=new X,_x=new X,fl=class extends Pu{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)gx.fromBufferAttribute(t,s),_x.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+gx.distanceTo(_x);e.setAttribute("lineDistance",new fi(i,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var pl=class extends pi{constructor(e=[],t=so,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var nr=class extends pi{constructor(e,t,i=fs,s,r,o,a=Hn,l=Hn,c,u=tr,f=1){if(u!==tr&&u!==sr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:f};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new sa(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ml=class extends nr{constructor(e,t=fs,i=so,s,r,o=Hn,a=Hn,l,c=tr){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},gl=class extends pi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},aa=class n extends Ki{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],d=0,p=0;m("z","y","x",-1,-1,i,t,e,o,r,0),m("z","y","x",1,-1,i,t,-e,o,r,1),m("x","z","y",1,1,e,i,t,s,o,2),m("x","z","y",1,-1,e,i,-t,s,o,3),m("x","y","z",1,-1,e,t,i,s,r,4),m("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new fi(c,3)),this.setAttribute("normal",new fi(u,3)),this.setAttribute("uv",new fi(f,2));function m(v,_,g,y,E,M,I,C,b,A,H){let F=M/b,D=I/A,G=M/2,V=I/2,N=C/2,W=b+1,Z=A+1,z=0,ue=0,K=new X;for(let Q=0;Q<Z;Q++){let re=Q*D-V;for(let fe=0;fe<W;fe++){let de=fe*F-G;K[v]=de*y,K[_]=re*E,K[g]=N,c.push(K.x,K.y,K.z),K[v]=0,K[_]=0,K[g]=C>0?1:-1,u.push(K.x,K.y,K.z),f.push(fe/b),f.push(1-Q/A),z+=1}}for(let Q=0;Q<A;Q++)for(let re=0;re<b;re++){let fe=d+re+W*Q,de=d+re+W*(Q+1),ee=d+(re+1)+W*(Q+1),ge=d+(re+1)+W*Q;l.push(fe,de,ge),l.push(de,ee,ge),ue+=6}a.addGroup(p,ue,H),p+=ue,d+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var _l=class n extends Ki{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,d=t/l,p=[],m=[],v=[],_=[];for(let g=0;g<u;g++){let y=g*d-o;for(let E=0;E<c;E++){let M=E*f-r;m.push(M,-y,0),v.push(0,0,1),_.push(E/a),_.push(1-g/l)}}for(let g=0;g<l;g++)for(let y=0;y<a;y++){let E=y+c*g,M=y+c*(g+1),I=y+1+c*(g+1),C=y+1+c*g;p.push(E,M,C),p.push(M,I,C)}this.setIndex(p),this.setAttribute("position",new fi(m,3)),this.setAttribute("normal",new fi(v,3)),this.setAttribute("uv",new fi(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function lo(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(xx(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(xx(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function jn(n){let e={};for(let t=0;t<n.length;t++){let i=lo(n[t]);for(let s in i)e[s]=i[s]}return e}function xx(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function V1(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Hp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:bt.workingColorSpace}var uy={clone:lo,merge:jn},z1=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,G1=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ns=class extends Er{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=z1,this.fragmentShader=G1,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=lo(e.uniforms),this.uniformsGroups=V1(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new Ct().setHex(s.value);break;case"v2":this.uniforms[i].value=new Et().fromArray(s.value);break;case"v3":this.uniforms[i].value=new X().fromArray(s.value);break;case"v4":this.uniforms[i].value=new an().fromArray(s.value);break;case"m3":this.uniforms[i].value=new rt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Jt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},la=class extends Ns{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Iu=class extends Er{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Yx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Lu=class extends Er{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Zo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function su(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Rr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Du=class extends Rr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:hp,endingEnd:hp}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case dp:r=e,a=2*t-i;break;case fp:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case dp:o=e,l=2*i-t;break;case fp:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,d=this._weightPrev,p=this._weightNext,m=(i-t)/(s-t),v=m*m,_=v*m,g=-d*_+2*d*v-d*m,y=(1+d)*_+(-1.5-2*d)*v+(-.5+d)*m+1,E=(-1-p)*_+(1.5+p)*v+.5*m,M=p*_-p*v;for(let I=0;I!==a;++I)r[I]=g*o[u+I]+y*o[c+I]+E*o[l+I]+M*o[f+I];return r}},Nu=class extends Rr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*f+o[l+d]*u;return r}},Fu=class extends Rr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Uu=class extends Rr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let m=(i-t)/(s-t),v=1-m;for(let _=0;_!==a;++_)r[_]=o[c+_]*v+o[l+_]*m;return r}let d=a*2,p=e-1;for(let m=0;m!==a;++m){let v=o[c+m],_=o[l+m],g=p*d+m*2,y=f[g],E=f[g+1],M=e*d+m*2,I=u[M],C=u[M+1],b=W1(i,t,y,I,s);r[m]=hy(b,v,E,C,_)}return r}};function hy(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function H1(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function W1(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=hy(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=H1(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ni=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Zo(t,this.TimeBufferType),this.values=Zo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Zo(e.times,Array),values:Zo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),su(e.settings)&&(i.settings={inTangents:Zo(e.settings.inTangents,Array),outTangents:Zo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Fu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Nu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Du(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Uu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case nl:t=this.InterpolantFactoryMethodDiscrete;break;case yu:t=this.InterpolantFactoryMethodLinear;break;case lu:t=this.InterpolantFactoryMethodSmooth;break;case up:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ke("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return nl;case this.InterpolantFactoryMethodLinear:return yu;case this.InterpolantFactoryMethodSmooth:return lu;case this.InterpolantFactoryMethodBezier:return up}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;su(this.settings)&&(yx(this.settings.inTangents,e),yx(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;su(this.settings)&&(vx(this.settings.inTangents,e),vx(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(st("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(st("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){st("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){st("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&v1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){st("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===lu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,d=f-i,p=f+i;for(let m=0;m!==i;++m){let v=t[f+m];if(v!==t[d+m]||v!==t[p+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,d=o*i;for(let p=0;p!==i;++p)t[d+p]=t[f+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,su(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function yx(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function vx(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Ni.prototype.ValueTypeName="";Ni.prototype.TimeBufferType=Float32Array;Ni.prototype.ValueBufferType=Float32Array;Ni.prototype.DefaultInterpolation=yu;var Pr=class extends Ni{constructor(e,t,i){super(e,t,i)}};Pr.prototype.ValueTypeName="bool";Pr.prototype.ValueBufferType=Array;Pr.prototype.DefaultInterpolation=nl;Pr.prototype.InterpolantFactoryMethodLinear=void 0;Pr.prototype.InterpolantFactoryMethodSmooth=void 0;var ku=class extends Ni{constructor(e,t,i,s){super(e,t,i,s)}};ku.prototype.ValueTypeName="color";var Ou=class extends Ni{constructor(e,t,i,s){super(e,t,i,s)}};Ou.prototype.ValueTypeName="number";var Bu=class extends Rr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Ds.slerpFlat(r,0,o,c-a,o,c,l);return r}},xl=class extends Ni{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Bu(this.times,this.values,this.getValueSize(),e)}};xl.prototype.ValueTypeName="quaternion";xl.prototype.InterpolantFactoryMethodSmooth=void 0;var Ir=class extends Ni{constructor(e,t,i){super(e,t,i)}};Ir.prototype.ValueTypeName="string";Ir.prototype.ValueBufferType=Array;Ir.prototype.DefaultInterpolation=nl;Ir.prototype.InterpolantFactoryMethodLinear=void 0;Ir.prototype.InterpolantFactoryMethodSmooth=void 0;var Vu=class extends Ni{constructor(e,t,i,s){super(e,t,i,s)}};Vu.prototype.ValueTypeName="vector";var zu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,d=c.length;f<d;f+=2){let p=c[f],m=c[f+1];if(p.global&&(p.lastIndex=0),p.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},dy=new zu,Gu=class{constructor(e){this.manager=e!==void 0?e:dy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Gu.DEFAULT_MATERIAL_NAME="__DEFAULT";var ru=new X,ou=new Ds,Rs=new X,eo=class extends Di{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Jt,this.projectionMatrix=new Jt,this.projectionMatrixInverse=new Jt,this.coordinateSystem=Zi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ru,ou,Rs),Rs.x===1&&Rs.y===1&&Rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ru,ou,Rs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(ru,ou,Rs),Rs.x===1&&Rs.y===1&&Rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ru,ou,Rs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},wr=new X,bx=new Et,Sx=new Et,Ii=class extends eo{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=vu*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(zf*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return vu*2*Math.atan(Math.tan(zf*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){wr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(wr.x,wr.y).multiplyScalar(-e/wr.z),wr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(wr.x,wr.y).multiplyScalar(-e/wr.z)}getViewSize(e,t){return this.getViewBounds(e,bx,Sx),t.subVectors(Sx,bx)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(zf*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Hu=class extends eo{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var to=class extends Ki{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Ko=-90,jo=1,ca=class extends Di{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ii(Ko,jo,e,t);s.layers=this.layers,this.add(s);let r=new Ii(Ko,jo,e,t);r.layers=this.layers,this.add(r);let o=new Ii(Ko,jo,e,t);o.layers=this.layers,this.add(o);let a=new Ii(Ko,jo,e,t);a.layers=this.layers,this.add(a);let l=new Ii(Ko,jo,e,t);l.layers=this.layers,this.add(l);let c=new Ii(Ko,jo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Zi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===sl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),d=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let _=!1;e.isWebGLRenderer===!0?_=e.state.buffers.depth.getReversed():_=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,d,p),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Wu=class extends Ii{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Wp="\\[\\]\\.:\\/",$1=new RegExp("["+Wp+"]","g"),$p="[^"+Wp+"]",X1="[^"+Wp.replace("\\.","")+"]",q1=/((?:WC+[\/:])*)/.source.replace("WC",$p),Y1=/(WCOD+)?/.source.replace("WCOD",X1),J1=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",$p),Z1=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",$p),K1=new RegExp("^"+q1+Y1+J1+Z1+"$"),j1=["material","materials","bones","map"],pp=class{constructor(e,t,i){let s=i||tn.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},tn=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace($1,"")}static parseTrackName(e){let t=K1.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);j1.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){st("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){st("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){st("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){st("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){st("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;st("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};tn.Composite=pp;tn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};tn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};tn.prototype.GetterByBindingType=[tn.prototype._getValue_direct,tn.prototype._getValue_array,tn.prototype._getValue_arrayElement,tn.prototype._getValue_toArray];tn.prototype.SetterByBindingTypeAndVersioning=[[tn.prototype._setValue_direct,tn.prototype._setValue_direct_setNeedsUpdate,tn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[tn.prototype._setValue_array,tn.prototype._setValue_array_setNeedsUpdate,tn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[tn.prototype._setValue_arrayElement,tn.prototype._setValue_arrayElement_setNeedsUpdate,tn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[tn.prototype._setValue_fromArray,tn.prototype._setValue_fromArray_setNeedsUpdate,tn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var GL=new Float32Array(1);var ua=class extends wu{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var mp=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Mx=new X,au=new X,Qo=new X,ea=new X,cp=new X,Q1=new X,eT=new X,yl=class{constructor(e=new X,t=new X){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){Mx.subVectors(e,this.start),au.subVectors(this.end,this.start);let i=au.dot(au);if(i===0)return 0;let r=au.dot(Mx)/i;return t&&(r=dt(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=Q1,i=eT){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;Qo.subVectors(c,a),ea.subVectors(u,l),cp.subVectors(a,l);let f=Qo.dot(Qo),d=ea.dot(ea),p=ea.dot(cp);if(f<=s&&d<=s)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(f<=s)r=0,o=p/d,o=dt(o,0,1);else{let m=Qo.dot(cp);if(d<=s)o=0,r=dt(-m/f,0,1);else{let v=Qo.dot(ea),_=f*d-v*v;_!==0?r=dt((v*p-m*d)/_,0,1):r=0,o=(v*r+p)/d,o<0?(o=0,r=dt(-m/f,0,1)):o>1&&(o=1,r=dt((v-m)/f,0,1))}}return t.copy(a).addScaledVector(Qo,r),i.copy(l).addScaledVector(ea,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};function Xp(n,e,t,i){let s=tT(i);switch(t){case Fp:return n*e;case kp:return n*e/s.components*s.byteLength;case Ku:return n*e/s.components*s.byteLength;case Dr:return n*e*2/s.components*s.byteLength;case ju:return n*e*2/s.components*s.byteLength;case Up:return n*e*3/s.components*s.byteLength;case ki:return n*e*4/s.components*s.byteLength;case Qu:return n*e*4/s.components*s.byteLength;case Sl:case Ml:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case wl:case Tl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case th:case ih:return Math.max(n,16)*Math.max(e,8)/4;case eh:case nh:return Math.max(n,8)*Math.max(e,8)/2;case sh:case rh:case ah:case lh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case oh:case Al:case ch:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case uh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case hh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case dh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case fh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case ph:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case mh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case gh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case _h:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case xh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case yh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case vh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case bh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Sh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Mh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case wh:case Th:case Ah:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Eh:case Ch:return Math.ceil(n/4)*Math.ceil(e/4)*8;case El:case Rh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function tT(n){switch(n){case Fi:case Ip:return{byteLength:1,components:1};case pa:case Lp:case ps:return{byteLength:2,components:1};case Ju:case Zu:return{byteLength:2,components:4};case fs:case Yu:case Ui:return{byteLength:4,components:1};case Dp:case Np:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Ny(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function iT(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((p,m)=>p.start-m.start);let d=0;for(let p=1;p<f.length;p++){let m=f[d],v=f[p];v.start<=m.start+m.count+1?m.count=Math.max(m.count,v.start+v.count-m.start):(++d,f[d]=v)}f.length=d+1;for(let p=0,m=f.length;p<m;p++){let v=f[p];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var sT=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,rT=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,oT=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,aT=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,lT=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,cT=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,uT=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,hT=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,dT=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,fT=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,pT=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,mT=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,gT=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,_T=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,xT=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,yT=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,vT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,bT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ST=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,MT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,wT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,TT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,AT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,ET=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,CT=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,RT=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,PT=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,IT=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,LT=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,DT="gl_FragColor = linearToOutputTexel( gl_FragColor );",NT=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,FT=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,UT=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,kT=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,OT=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,BT=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,VT=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,zT=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,GT=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,HT=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,WT=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,$T=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,XT=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,qT=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,YT=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,JT=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,ZT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,KT=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,jT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,QT=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,eA=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,tA=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,nA=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,iA=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,sA=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,rA=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,oA=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,aA=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,lA=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,cA=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,uA=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,hA=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,dA=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,fA=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,pA=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,mA=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,gA=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,_A=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,xA=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,yA=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,vA=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,bA=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,SA=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,MA=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,wA=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,TA=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,AA=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,EA=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,CA=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,RA=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,PA=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,IA=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,LA=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,DA=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,NA=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,FA=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,UA=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,kA=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,OA=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,BA=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,VA=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,zA=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,GA=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,HA=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,WA=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,$A=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,XA=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,qA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,YA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,JA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,ZA=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,KA=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,jA=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,QA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,eE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,tE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,nE=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,iE=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,sE=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,rE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,oE=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,aE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,lE=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cE=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,uE=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,hE=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,dE=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,fE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,pE=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mE=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,gE=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,_E=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,xE=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yE=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,vE=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bE=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,SE=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ME=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,wE=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,TE=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,AE=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,EE=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,CE=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,RE=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,PE=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,IE=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,LE=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,DE=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,NE=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,FE=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,UE=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,gt={alphahash_fragment:sT,alphahash_pars_fragment:rT,alphamap_fragment:oT,alphamap_pars_fragment:aT,alphatest_fragment:lT,alphatest_pars_fragment:cT,aomap_fragment:uT,aomap_pars_fragment:hT,batching_pars_vertex:dT,batching_vertex:fT,begin_vertex:pT,beginnormal_vertex:mT,bsdfs:gT,iridescence_fragment:_T,bumpmap_pars_fragment:xT,clipping_planes_fragment:yT,clipping_planes_pars_fragment:vT,clipping_planes_pars_vertex:bT,clipping_planes_vertex:ST,color_fragment:MT,color_pars_fragment:wT,color_pars_vertex:TT,color_vertex:AT,common:ET,defaultnormal_vertex:CT,displacementmap_pars_vertex:RT,displacementmap_vertex:PT,emissivemap_fragment:IT,emissivemap_pars_fragment:LT,colorspace_fragment:DT,colorspace_pars_fragment:NT,envmap_fragment:FT,envmap_common_pars_fragment:UT,envmap_pars_fragment:kT,envmap_pars_vertex:OT,envmap_physical_pars_fragment:JT,envmap_vertex:BT,fog_vertex:VT,fog_pars_vertex:zT,fog_fragment:GT,fog_pars_fragment:HT,gradientmap_pars_fragment:WT,lightmap_pars_fragment:$T,lights_lambert_fragment:XT,lights_lambert_pars_fragment:qT,lights_pars_begin:YT,lights_toon_fragment:ZT,lights_toon_pars_fragment:KT,lights_phong_fragment:jT,lights_phong_pars_fragment:QT,lights_physical_fragment:eA,lights_physical_pars_fragment:tA,lights_fragment_begin:nA,lights_fragment_maps:iA,lights_fragment_end:sA,lightprobes_pars_fragment:rA,logdepthbuf_fragment:oA,logdepthbuf_pars_fragment:aA,logdepthbuf_pars_vertex:lA,logdepthbuf_vertex:cA,map_fragment:uA,map_pars_fragment:hA,map_particle_fragment:dA,map_particle_pars_fragment:fA,metalnessmap_fragment:pA,metalnessmap_pars_fragment:mA,morphinstance_vertex:gA,morphcolor_vertex:_A,morphnormal_vertex:xA,morphtarget_pars_vertex:yA,morphtarget_vertex:vA,normal_fragment_begin:bA,normal_fragment_maps:SA,normal_pars_fragment:MA,normal_pars_vertex:wA,normal_vertex:TA,normalmap_pars_fragment:AA,clearcoat_normal_fragment_begin:EA,clearcoat_normal_fragment_maps:CA,clearcoat_pars_fragment:RA,iridescence_pars_fragment:PA,opaque_fragment:IA,packing:LA,premultiplied_alpha_fragment:DA,project_vertex:NA,dithering_fragment:FA,dithering_pars_fragment:UA,roughnessmap_fragment:kA,roughnessmap_pars_fragment:OA,shadowmap_pars_fragment:BA,shadowmap_pars_vertex:VA,shadowmap_vertex:zA,shadowmask_pars_fragment:GA,skinbase_vertex:HA,skinning_pars_vertex:WA,skinning_vertex:$A,skinnormal_vertex:XA,specularmap_fragment:qA,specularmap_pars_fragment:YA,tonemapping_fragment:JA,tonemapping_pars_fragment:ZA,transmission_fragment:KA,transmission_pars_fragment:jA,uv_pars_fragment:QA,uv_pars_vertex:eE,uv_vertex:tE,worldpos_vertex:nE,background_vert:iE,background_frag:sE,backgroundCube_vert:rE,backgroundCube_frag:oE,cube_vert:aE,cube_frag:lE,depth_vert:cE,depth_frag:uE,distance_vert:hE,distance_frag:dE,equirect_vert:fE,equirect_frag:pE,linedashed_vert:mE,linedashed_frag:gE,meshbasic_vert:_E,meshbasic_frag:xE,meshlambert_vert:yE,meshlambert_frag:vE,meshmatcap_vert:bE,meshmatcap_frag:SE,meshnormal_vert:ME,meshnormal_frag:wE,meshphong_vert:TE,meshphong_frag:AE,meshphysical_vert:EE,meshphysical_frag:CE,meshtoon_vert:RE,meshtoon_frag:PE,points_vert:IE,points_frag:LE,shadow_vert:DE,shadow_frag:NE,sprite_vert:FE,sprite_frag:UE},Ne={common:{diffuse:{value:new Ct(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new rt}},envmap:{envMap:{value:null},envMapRotation:{value:new rt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new rt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new rt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new rt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new rt},normalScale:{value:new Et(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new rt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new rt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new rt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new rt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ct(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ct(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0},uvTransform:{value:new rt}},sprite:{diffuse:{value:new Ct(16777215)},opacity:{value:1},center:{value:new Et(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}}},ks={basic:{uniforms:jn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:gt.meshbasic_vert,fragmentShader:gt.meshbasic_frag},lambert:{uniforms:jn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new Ct(0)},envMapIntensity:{value:1}}]),vertexShader:gt.meshlambert_vert,fragmentShader:gt.meshlambert_frag},phong:{uniforms:jn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new Ct(0)},specular:{value:new Ct(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:gt.meshphong_vert,fragmentShader:gt.meshphong_frag},standard:{uniforms:jn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new Ct(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag},toon:{uniforms:jn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new Ct(0)}}]),vertexShader:gt.meshtoon_vert,fragmentShader:gt.meshtoon_frag},matcap:{uniforms:jn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:gt.meshmatcap_vert,fragmentShader:gt.meshmatcap_frag},points:{uniforms:jn([Ne.points,Ne.fog]),vertexShader:gt.points_vert,fragmentShader:gt.points_frag},dashed:{uniforms:jn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:gt.linedashed_vert,fragmentShader:gt.linedashed_frag},depth:{uniforms:jn([Ne.common,Ne.displacementmap]),vertexShader:gt.depth_vert,fragmentShader:gt.depth_frag},normal:{uniforms:jn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:gt.meshnormal_vert,fragmentShader:gt.meshnormal_frag},sprite:{uniforms:jn([Ne.sprite,Ne.fog]),vertexShader:gt.sprite_vert,fragmentShader:gt.sprite_frag},background:{uniforms:{uvTransform:{value:new rt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:gt.background_vert,fragmentShader:gt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new rt}},vertexShader:gt.backgroundCube_vert,fragmentShader:gt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:gt.cube_vert,fragmentShader:gt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:gt.equirect_vert,fragmentShader:gt.equirect_frag},distance:{uniforms:jn([Ne.common,Ne.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:gt.distance_vert,fragmentShader:gt.distance_frag},shadow:{uniforms:jn([Ne.lights,Ne.fog,{color:{value:new Ct(0)},opacity:{value:1}}]),vertexShader:gt.shadow_vert,fragmentShader:gt.shadow_frag}};ks.physical={uniforms:jn([ks.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new rt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new rt},clearcoatNormalScale:{value:new Et(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new rt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new rt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new rt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new rt},sheen:{value:0},sheenColor:{value:new Ct(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new rt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new rt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new rt},transmissionSamplerSize:{value:new Et},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new rt},attenuationDistance:{value:0},attenuationColor:{value:new Ct(0)},specularColor:{value:new Ct(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new rt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new rt},anisotropyVector:{value:new Et},anisotropyMap:{value:null},anisotropyMapTransform:{value:new rt}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag};var Ih={r:0,b:0,g:0},kE=new Jt,Fy=new rt;Fy.set(-1,0,0,0,1,0,0,0,1);function OE(n,e,t,i,s,r){let o=new Ct(0),a=s===!0?0:1,l,c,u=null,f=0,d=null;function p(y){let E=y.isScene===!0?y.background:null;if(E&&E.isTexture){let M=y.backgroundBlurriness>0;E=e.get(E,M)}return E}function m(y){let E=!1,M=p(y);M===null?_(o,a):M&&M.isColor&&(_(M,1),E=!0);let I=n.xr.getEnvironmentBlendMode();I==="additive"?t.buffers.color.setClear(0,0,0,1,r):I==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(y,E){let M=p(E);M&&M.isCubeTexture?(c===void 0&&(c=new Xn(new aa(1,1,1),new Ns({name:"BackgroundCubeMaterial",uniforms:lo(ks.backgroundCube.uniforms),vertexShader:ks.backgroundCube.vertexShader,fragmentShader:ks.backgroundCube.fragmentShader,side:ui,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(I,C,b){this.matrixWorld.copyPosition(b.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(kE.makeRotationFromEuler(E.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Fy),c.material.toneMapped=bt.getTransfer(M.colorSpace)!==Ft,(u!==M||f!==M.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=M,f=M.version,d=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Xn(new _l(2,2),new Ns({name:"BackgroundMaterial",uniforms:lo(ks.background.uniforms),vertexShader:ks.background.vertexShader,fragmentShader:ks.background.fragmentShader,side:Lr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=bt.getTransfer(M.colorSpace)!==Ft,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(u!==M||f!==M.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=M,f=M.version,d=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function _(y,E){y.getRGB(Ih,Hp(n)),t.buffers.color.setClear(Ih.r,Ih.g,Ih.b,E,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,E=1){o.set(y),a=E,_(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,_(o,a)},render:m,addToRenderList:v,dispose:g}}function BE(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(D,G,V,N,W){let Z=!1,z=f(D,N,V,G);r!==z&&(r=z,c(r.object)),Z=p(D,N,V,W),Z&&m(D,N,V,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,M(D,G,V,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function f(D,G,V,N){let W=N.wireframe===!0,Z=i[G.id];Z===void 0&&(Z={},i[G.id]=Z);let z=D.isInstancedMesh===!0?D.id:0,ue=Z[z];ue===void 0&&(ue={},Z[z]=ue);let K=ue[V.id];K===void 0&&(K={},ue[V.id]=K);let Q=K[W];return Q===void 0&&(Q=d(l()),K[W]=Q),Q}function d(D){let G=[],V=[],N=[];for(let W=0;W<t;W++)G[W]=0,V[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:V,attributeDivisors:N,object:D,attributes:{},index:null}}function p(D,G,V,N){let W=r.attributes,Z=G.attributes,z=0,ue=V.getAttributes();for(let K in ue)if(ue[K].location>=0){let re=W[K],fe=Z[K];if(fe===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(fe=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(fe=D.instanceColor)),re===void 0||re.attribute!==fe||fe&&re.data!==fe.data)return!0;z++}return r.attributesNum!==z||r.index!==N}function m(D,G,V,N){let W={},Z=G.attributes,z=0,ue=V.getAttributes();for(let K in ue)if(ue[K].location>=0){let re=Z[K];re===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(re=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(re=D.instanceColor));let fe={};fe.attribute=re,re&&re.data&&(fe.data=re.data),W[K]=fe,z++}r.attributes=W,r.attributesNum=z,r.index=N}function v(){let D=r.newAttributes;for(let G=0,V=D.length;G<V;G++)D[G]=0}function _(D){g(D,0)}function g(D,G){let V=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;V[D]=1,N[D]===0&&(n.enableVertexAttribArray(D),N[D]=1),W[D]!==G&&(n.vertexAttribDivisor(D,G),W[D]=G)}function y(){let D=r.newAttributes,G=r.enabledAttributes;for(let V=0,N=G.length;V<N;V++)G[V]!==D[V]&&(n.disableVertexAttribArray(V),G[V]=0)}function E(D,G,V,N,W,Z,z){z===!0?n.vertexAttribIPointer(D,G,V,W,Z):n.vertexAttribPointer(D,G,V,N,W,Z)}function M(D,G,V,N){v();let W=N.attributes,Z=V.getAttributes(),z=G.defaultAttributeValues;for(let ue in Z){let K=Z[ue];if(K.location>=0){let Q=W[ue];if(Q===void 0&&(ue==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),ue==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let re=Q.normalized,fe=Q.itemSize,de=e.get(Q);if(de===void 0)continue;let ee=de.buffer,ge=de.type,ye=de.bytesPerElement,Ce=ge===n.INT||ge===n.UNSIGNED_INT||Q.gpuType===Yu;if(Q.isInterleavedBufferAttribute){let Me=Q.data,Xe=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,ct=Q.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let We=0;We<K.locationSize;We++)g(K.location+We,Me.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let We=0;We<K.locationSize;We++)_(K.location+We);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let We=0;We<K.locationSize;We++)E(K.location+We,fe/K.locationSize,ge,re,Xe*ye,(ct+fe/K.locationSize*We)*ye,Ce)}else{if(Q.isInstancedBufferAttribute){for(let Me=0;Me<K.locationSize;Me++)g(K.location+Me,Q.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Me=0;Me<K.locationSize;Me++)_(K.location+Me);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Me=0;Me<K.locationSize;Me++)E(K.location+Me,fe/K.locationSize,ge,re,fe*ye,fe/K.locationSize*Me*ye,Ce)}}else if(z!==void 0){let re=z[ue];if(re!==void 0)switch(re.length){case 2:n.vertexAttrib2fv(K.location,re);break;case 3:n.vertexAttrib3fv(K.location,re);break;case 4:n.vertexAttrib4fv(K.location,re);break;default:n.vertexAttrib1fv(K.location,re)}}}}y()}function I(){H();for(let D in i){let G=i[D];for(let V in G){let N=G[V];for(let W in N){let Z=N[W];for(let z in Z)u(Z[z].object),delete Z[z];delete N[W]}}delete i[D]}}function C(D){if(i[D.id]===void 0)return;let G=i[D.id];for(let V in G){let N=G[V];for(let W in N){let Z=N[W];for(let z in Z)u(Z[z].object),delete Z[z];delete N[W]}}delete i[D.id]}function b(D){for(let G in i){let V=i[G];for(let N in V){let W=V[N];if(W[D.id]===void 0)continue;let Z=W[D.id];for(let z in Z)u(Z[z].object),delete Z[z];delete W[D.id]}}}function A(D){for(let G in i){let V=i[G],N=D.isInstancedMesh===!0?D.id:0,W=V[N];if(W!==void 0){for(let Z in W){let z=W[Z];for(let ue in z)u(z[ue].object),delete z[ue];delete W[Z]}delete V[N],Object.keys(V).length===0&&delete i[G]}}}function H(){F(),o=!0,r!==s&&(r=s,c(r.object))}function F(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:H,resetDefaultState:F,dispose:I,releaseStatesOfGeometry:C,releaseStatesOfObject:A,releaseStatesOfProgram:b,initAttributes:v,enableAttribute:_,disableUnusedAttributes:y}}function VE(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let p=0;p<u;p++)d+=c[p];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function zE(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let b=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(b.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(b){return!(b!==ki&&i.convert(b)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(b){let A=b===ps&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(b!==Fi&&b!==Ui&&!A&&i.convert(b)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(b){if(b==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";b="mediump"}return b==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ke("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),_=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),I=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:m,maxTextureSize:v,maxCubemapSize:_,maxAttributes:g,maxVertexUniforms:y,maxVaryings:E,maxFragmentUniforms:M,maxSamples:I,samples:C}}function GE(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Pi,a=new rt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){let p=f.length!==0||d||i!==0||s;return s=d,i=f.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,d){t=u(f,d,0)},this.setState=function(f,d,p){let m=f.clippingPlanes,v=f.clipIntersection,_=f.clipShadows,g=n.get(f);if(!s||m===null||m.length===0||r&&!_)r?u(null):c();else{let y=r?0:i,E=y*4,M=g.clippingState||null;l.value=M,M=u(m,d,E,p);for(let I=0;I!==E;++I)M[I]=t[I];g.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,d,p,m){let v=f!==null?f.length:0,_=null;if(v!==0){if(_=l.value,m!==!0||_===null){let g=p+v*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(_===null||_.length<g)&&(_=new Float32Array(g));for(let E=0,M=p;E!==v;++E,M+=4)o.copy(f[E]).applyMatrix4(y,a),o.normal.toArray(_,M),_[M+3]=o.constant}l.value=_,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,_}}var Il=class extends Li{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new pl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new aa(5,5,5),r=new Ns({name:"CubemapFromEquirect",uniforms:lo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ui,blending:no});r.uniforms.tEquirect.value=t;let o=new Xn(s,r),a=t.minFilter;return t.minFilter===ir&&(t.minFilter=ci),new ca(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},fy=256,HE=3,WE=20,Uy=256,ky=16,$E=3,XE=new X,qE=new Ct,Dh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ca(1,10,null),this._boxMesh=new Xn(new aa(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=XE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,d=l.autoClearColor,p=l.autoClearDepth,m=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(qE));let _=new ca(i,s,u);return _.position.copy(a),_.update(l,e),l.autoClear=f,l.autoClearColor=d,l.autoClearDepth=p,l.autoClearStencil=m,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=gy(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=my(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(fy,oy(e))}_fromTexture(e,t){e.mapping===so||e.mapping===fa?this._setSize(e.image.length===0?fy:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=py(e,!1,!1),i=Math.log2(e)-HE;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=py(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===so||e.mapping===fa?(this._cubemapMaterial===null&&(this._cubemapMaterial=gy()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=my()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=YE(),this._integrationMaterial=JE());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/ky);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-$E)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Uy*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=ZE());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function py(n,e,t){return new Il(n,{minFilter:ir,generateMipmaps:e,type:ps,colorSpace:Zr,depthBuffer:t})}function Ll(n,e,t){return new Ns({name:n,uniforms:e,vertexShader:gt.cube_vert,fragmentShader:t,side:ui,blending:no,depthTest:!1,depthWrite:!1})}function YE(){return Ll("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Uy}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function JE(){return Ll("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:ky}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ZE(){return Ll("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${WE}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function my(){return Ll("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function gy(){return Ll("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function KE(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,p=!1){return d==null?null:p?o(d):r(d)}function r(d){if(d&&d.isTexture){let p=d.mapping;if(p===$u||p===Xu)if(e.has(d)){let m=e.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let v=new Il(m.height);return v.fromEquirectangularTexture(n,d),e.set(d,v),d.addEventListener("dispose",c),a(v.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let p=d.mapping,m=p===$u||p===Xu,v=p===so||p===fa;if(m||v){let _=t.get(d),g=_!==void 0?_.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Dh(n)),_=m?i.fromEquirectangular(d,_):i.fromCubemap(d,_),_.texture.pmremVersion=d.pmremVersion,t.set(d,_),_.texture;if(_!==void 0)return _.texture;{let y=d.image;return m&&y&&y.height>0||v&&y&&l(y)?(i===null&&(i=new Dh(n)),_=m?i.fromEquirectangular(d):i.fromCubemap(d),_.texture.pmremVersion=d.pmremVersion,t.set(d,_),d.addEventListener("dispose",u),_.texture):null}}}return d}function a(d,p){return p===$u?d.mapping=so:p===Xu&&(d.mapping=fa),d}function l(d){let p=0,m=6;for(let v=0;v<m;v++)d[v]!==void 0&&p++;return p===m}function c(d){let p=d.target;p.removeEventListener("dispose",c);let m=e.get(p);m!==void 0&&(e.delete(p),m.dispose())}function u(d){let p=d.target;p.removeEventListener("dispose",u);let m=t.get(p);m!==void 0&&(t.delete(p),m.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function jE(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&tl("WebGLRenderer: "+i+" extension not supported."),s}}}function QE(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let _ in m.attributes)e.remove(m.attributes[_]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let v=r.get(m);v&&(e.remove(v),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function u(m){let v=m.attributes;for(let _ in v)e.update(v[_],n.ARRAY_BUFFER)}function f(m){let v=m.index,_=m.attributes.position,g=0;if(_===void 0)return;let y=v!==null?v.array.length:_.array.length/3-1,E=_.count>=65535?hl:ul,M=new E(Math.ceil(y/3)*6,1),I=M.array;if(v!==null){let b=v.array;g=v.version;for(let A=0,H=0;A<y;A+=3){let F=b[A+0],D=b[A+1],G=b[A+2];I[H++]=F,I[H++]=D,I[H++]=D,I[H++]=G,I[H++]=G,I[H++]=F}}else{g=_.version;for(let b=0,A=0;b<y;b+=3){let H=b+0,F=b+1,D=b+2;I[A++]=H,I[A++]=F,I[A++]=F,I[A++]=D,I[A++]=D,I[A++]=H}}M.version=g;let C=r.get(m);C&&e.remove(C),r.set(m,M)}function d(m){let v=r.get(m);if(v){let _=m.index;_!==null&&v.version<_.version&&f(m)}else f(m);return r.get(m)}function p(){for(let m in s){let v=s[m].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:d,dispose:p}}function eC(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){n.drawElements(i,d,r,f*o),t.update(d,i,1)}function c(f,d,p){p!==0&&(n.drawElementsInstanced(i,d,r,f*o,p),t.update(d,i,p))}function u(f,d,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,f,0,p);let v=0;for(let _=0;_<p;_++)v+=d[_];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function tC(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:st("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function nC(n,e,t){let i=new WeakMap,s=new an;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==f){let H=function(){b.dispose(),i.delete(a),a.removeEventListener("dispose",H)};d!==void 0&&d.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,_=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],E=0;p===!0&&(E=1),m===!0&&(E=2),v===!0&&(E=3);let M=a.attributes.position.count*E,I=1;M>e.maxTextureSize&&(I=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let C=new Float32Array(M*I*4*f),b=new al(C,M,I,f);b.type=Ui,b.needsUpdate=!0;let A=E*4;for(let F=0;F<f;F++){let D=_[F],G=g[F],V=y[F],N=M*I*4*F;for(let W=0;W<D.count;W++){let Z=W*A;p===!0&&(s.fromBufferAttribute(D,W),C[N+Z+0]=s.x,C[N+Z+1]=s.y,C[N+Z+2]=s.z,C[N+Z+3]=0),m===!0&&(s.fromBufferAttribute(G,W),C[N+Z+4]=s.x,C[N+Z+5]=s.y,C[N+Z+6]=s.z,C[N+Z+7]=0),v===!0&&(s.fromBufferAttribute(V,W),C[N+Z+8]=s.x,C[N+Z+9]=s.y,C[N+Z+10]=s.z,C[N+Z+11]=V.itemSize===4?s.w:1)}}d={count:f,texture:b,size:new Et(M,I)},i.set(a,d),a.addEventListener("dispose",H)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let v=0;v<c.length;v++)p+=c[v];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function iC(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,d=e.get(c,f);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var sC={[Mp]:"LINEAR_TONE_MAPPING",[wp]:"REINHARD_TONE_MAPPING",[Tp]:"CINEON_TONE_MAPPING",[Ap]:"ACES_FILMIC_TONE_MAPPING",[Cp]:"AGX_TONE_MAPPING",[Rp]:"NEUTRAL_TONE_MAPPING",[Ep]:"CUSTOM_TONE_MAPPING"};function rC(n,e,t,i,s,r){let o=new Li(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Ki;u.setAttribute("position",new fi([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new fi([0,2,0,0,2,0],2));let f=new la({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Xn(u,f),p=new Hu(-1,1,1,-1,0,1),m=null,v=null,_=!1,g,y=null,E=[],M=!1;this.setSize=function(I,C){o.setSize(I,C),a!==null&&a.setSize(I,C),l!==null&&l.setSize(I,C);for(let b=0;b<E.length;b++){let A=E[b];A.setSize&&A.setSize(I,C)}},this.setEffects=function(I){E=I,M=E.length>0&&E[0].isRenderPass===!0;let C=o.width,b=o.height;E.length>0&&a===null&&(a=new Li(C,b,{type:ps,depthBuffer:!1,stencilBuffer:!1}),l=new Li(C,b,{type:ps,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&E.some(H=>H.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new nr(C,b),r===!0&&(c.format=sr,c.type=ro)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let H=0;H<E.length;H++){let F=E[H];F.setSize&&F.setSize(C,b),A&&F.needsDepthTexture===!0&&F.setDepthTexture&&F.setDepthTexture(c)}},this.begin=function(I,C){if(_||I.toneMapping===Fs&&E.length===0)return!1;if(y=C,C!==null){let b=C.width,A=C.height;(o.width!==b||o.height!==A)&&this.setSize(b,A)}return M===!1&&I.setRenderTarget(o),g=I.toneMapping,I.toneMapping=Fs,!0},this.hasRenderPass=function(){return M},this.end=function(I,C){I.toneMapping=g,_=!0;let b=o,A=a;for(let H=0;H<E.length;H++){let F=E[H];F.enabled!==!1&&(F.render(I,A,b,C),F.needsSwap!==!1&&(b=A,A=A===a?l:a))}if(m!==I.outputColorSpace||v!==I.toneMapping){m=I.outputColorSpace,v=I.toneMapping,f.defines={},bt.getTransfer(m)===Ft&&(f.defines.SRGB_TRANSFER="");let H=sC[v];H&&(f.defines[H]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=b.texture,I.setRenderTarget(y),I.render(d,p),y=null,_=!1},this.isCompositing=function(){return _},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var Oy=new pi,By=new nr(1,1),Vy=new ml(1),zy=new al,Gy=new Mu,Hy=new pl,_y=[],xy=[],yy=new Float32Array(16),vy=new Float32Array(9),by=new Float32Array(4);function ga(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=_y[s];if(r===void 0&&(r=new Float32Array(s),_y[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Dn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Nn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Fh(n,e){let t=xy[e];t===void 0&&(t=new Int32Array(e),xy[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function oC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function aC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Dn(t,e))return;n.uniform2fv(this.addr,e),Nn(t,e)}}function lC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Dn(t,e))return;n.uniform3fv(this.addr,e),Nn(t,e)}}function cC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Dn(t,e))return;n.uniform4fv(this.addr,e),Nn(t,e)}}function uC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Dn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Nn(t,e)}else{if(Dn(t,i))return;by.set(i),n.uniformMatrix2fv(this.addr,!1,by),Nn(t,i)}}function hC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Dn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Nn(t,e)}else{if(Dn(t,i))return;vy.set(i),n.uniformMatrix3fv(this.addr,!1,vy),Nn(t,i)}}function dC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Dn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Nn(t,e)}else{if(Dn(t,i))return;yy.set(i),n.uniformMatrix4fv(this.addr,!1,yy),Nn(t,i)}}function fC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function pC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Dn(t,e))return;n.uniform2iv(this.addr,e),Nn(t,e)}}function mC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Dn(t,e))return;n.uniform3iv(this.addr,e),Nn(t,e)}}function gC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Dn(t,e))return;n.uniform4iv(this.addr,e),Nn(t,e)}}function _C(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function xC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Dn(t,e))return;n.uniform2uiv(this.addr,e),Nn(t,e)}}function yC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Dn(t,e))return;n.uniform3uiv(this.addr,e),Nn(t,e)}}function vC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Dn(t,e))return;n.uniform4uiv(this.addr,e),Nn(t,e)}}function Uh(n){return n.version===0&&(n.compareFunction=zp,n.needsUpdate=!0),n}function bC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Uh(By):r=Oy,t.setTexture2D(e||r,s)}function SC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Gy,s)}function MC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Uh(Vy):r=Hy,t.setTextureCube(e||r,s)}function wC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||zy,s)}function TC(n){switch(n){case 5126:return oC;case 35664:return aC;case 35665:return lC;case 35666:return cC;case 35674:return uC;case 35675:return hC;case 35676:return dC;case 5124:case 35670:return fC;case 35667:case 35671:return pC;case 35668:case 35672:return mC;case 35669:case 35673:return gC;case 5125:return _C;case 36294:return xC;case 36295:return yC;case 36296:return vC;case 35678:case 36198:case 36298:case 36306:case 35682:return bC;case 35679:case 36299:case 36307:return SC;case 35680:case 36300:case 36308:case 36293:return MC;case 36289:case 36303:case 36311:case 36292:return wC}}function AC(n,e){n.uniform1fv(this.addr,e)}function EC(n,e){let t=ga(e,this.size,2);n.uniform2fv(this.addr,t)}function CC(n,e){let t=ga(e,this.size,3);n.uniform3fv(this.addr,t)}function RC(n,e){let t=ga(e,this.size,4);n.uniform4fv(this.addr,t)}function PC(n,e){let t=ga(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function IC(n,e){let t=ga(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function LC(n,e){let t=ga(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function DC(n,e){n.uniform1iv(this.addr,e)}function NC(n,e){n.uniform2iv(this.addr,e)}function FC(n,e){n.uniform3iv(this.addr,e)}function UC(n,e){n.uniform4iv(this.addr,e)}function kC(n,e){n.uniform1uiv(this.addr,e)}function OC(n,e){n.uniform2uiv(this.addr,e)}function BC(n,e){n.uniform3uiv(this.addr,e)}function VC(n,e){n.uniform4uiv(this.addr,e)}function zC(n,e,t){let i=this.cache,s=e.length,r=Fh(t,s);Dn(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Uh(By):o=Oy;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function GC(n,e,t){let i=this.cache,s=e.length,r=Fh(t,s);Dn(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Gy,r[o])}function HC(n,e,t){let i=this.cache,s=e.length,r=Fh(t,s);Dn(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Uh(Vy):o=Hy;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function WC(n,e,t){let i=this.cache,s=e.length,r=Fh(t,s);Dn(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||zy,r[o])}function $C(n){switch(n){case 5126:return AC;case 35664:return EC;case 35665:return CC;case 35666:return RC;case 35674:return PC;case 35675:return IC;case 35676:return LC;case 5124:case 35670:return DC;case 35667:case 35671:return NC;case 35668:case 35672:return FC;case 35669:case 35673:return UC;case 5125:return kC;case 36294:return OC;case 36295:return BC;case 36296:return VC;case 35678:case 36198:case 36298:case 36306:case 35682:return zC;case 35679:case 36299:case 36307:return GC;case 35680:case 36300:case 36308:case 36293:return HC;case 36289:case 36303:case 36311:case 36292:return WC}}var Jp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=TC(t.type)}},Zp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=$C(t.type)}},Kp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},qp=/(\w+)(\])?(\[|\.)?/g;function Sy(n,e){n.seq.push(e),n.map[e.id]=e}function XC(n,e,t){let i=n.name,s=i.length;for(qp.lastIndex=0;;){let r=qp.exec(i),o=qp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Sy(t,c===void 0?new Jp(a,n,e):new Zp(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new Kp(a),Sy(t,f)),t=f}}}var ma=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);XC(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function My(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var qC=37297,YC=0;function JC(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var wy=new rt;function ZC(n){bt._getMatrix(wy,bt.workingColorSpace,n);let e=`mat3( ${wy.elements.map(t=>t.toFixed(4))} )`;switch(bt.getTransfer(n)){case il:return[e,"LinearTransferOETF"];case Ft:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Ty(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+JC(n.getShaderSource(e),a)}else return r}function KC(n,e){let t=ZC(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var jC={[Mp]:"Linear",[wp]:"Reinhard",[Tp]:"Cineon",[Ap]:"ACESFilmic",[Cp]:"AgX",[Rp]:"Neutral",[Ep]:"Custom"};function QC(n,e){let t=jC[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Lh=new X;function eR(){bt.getLuminanceCoefficients(Lh);let n=Lh.x.toFixed(4),e=Lh.y.toFixed(4),t=Lh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function tR(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Pl).join(`
`)}function nR(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function iR(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Pl(n){return n!==""}function Ay(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Ey(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var sR=/^[ \t]*#include +<([\w\d./]+)>/gm;function jp(n){return n.replace(sR,rR)}function rR(n,e){let t=gt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return jp(t)}var oR=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Cy(n){return n.replace(oR,aR)}function aR(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Ry(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var lR={[vl]:"SHADOWMAP_TYPE_PCF",[ha]:"SHADOWMAP_TYPE_VSM"};function cR(n){return lR[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var uR={[fa]:"ENVMAP_MODE_REFRACTION"};function hR(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":uR[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var dR={[Sp]:"ENVMAP_BLENDING_MULTIPLY",[$x]:"ENVMAP_BLENDING_MIX",[Xx]:"ENVMAP_BLENDING_ADD"};function fR(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":dR[n.combine]||"ENVMAP_BLENDING_NONE"}function pR(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=cR(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=hR(t),f=fR(t),d=tR(t),p=nR(r),m=s.createProgram(),v,_,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Pl).join(`
`),v.length>0&&(v+=`
`),_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Pl).join(`
`),_.length>0&&(_+=`
`)):(v=[Ry(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Pl).join(`
`),_=[Ry(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Fs?"#define TONE_MAPPING":"",t.toneMapping!==Fs?gt.tonemapping_pars_fragment:"",t.toneMapping!==Fs?QC("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",gt.colorspace_pars_fragment,KC("linearToOutputTexel",t.outputColorSpace),eR(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Pl).join(`
`)),o=jp(o),o=Ay(o,t),o=Ey(o,t),a=jp(a),a=Ay(a,t),a=Ey(a,t),o=Cy(o),a=Cy(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,v=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,_=["#define varying in",t.glslVersion===Cl?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Cl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+_);let y=g+v+o,E=g+_+a,M=My(s,s.VERTEX_SHADER,y),I=My(s,s.FRAGMENT_SHADER,E);s.attachShader(m,M),s.attachShader(m,I),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function C(F){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(m)||"",G=s.getShaderInfoLog(M)||"",V=s.getShaderInfoLog(I)||"",N=D.trim(),W=G.trim(),Z=V.trim(),z=!0,ue=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,M,I);else{let K=Ty(s,M,"vertex"),Q=Ty(s,I,"fragment");st("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+F.name+`
Material Type: `+F.type+`

Program Info Log: `+N+`
`+K+`
`+Q)}else N!==""?Ke("WebGLProgram: Program Info Log:",N):(W===""||Z==="")&&(ue=!1);ue&&(F.diagnostics={runnable:z,programLog:N,vertexShader:{log:W,prefix:v},fragmentShader:{log:Z,prefix:_}})}s.deleteShader(M),s.deleteShader(I),b=new ma(s,m),A=iR(s,m)}let b;this.getUniforms=function(){return b===void 0&&C(this),b};let A;this.getAttributes=function(){return A===void 0&&C(this),A};let H=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return H===!1&&(H=s.getProgramParameter(m,qC)),H},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=YC++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=M,this.fragmentShader=I,this}var mR=0,Qp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new em(e),t.set(e,i)),i}},em=class{constructor(e){this.id=mR++,this.code=e,this.usedTimes=0}};function gR(n){return n===Dr||n===Al||n===El}function _R(n,e,t,i,s,r){let o=new ll,a=new Qp,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(b){return l.add(b),b===0?"uv":`uv${b}`}function m(b,A,H,F,D,G){let V=F.fog,N=D.geometry,W=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?F.environment:null,Z=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap,z=e.get(b.envMap||W,Z),ue=d[b.type],K=i.precision;b.precision!==null&&(K=i.getMaxPrecision(b.precision),K!==b.precision&&Ke("WebGLProgram.getParameters:",b.precision,"not supported, using",K,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,re=Q!==void 0?Q.length:0,fe=0;N.morphAttributes.position!==void 0&&(fe=1),N.morphAttributes.normal!==void 0&&(fe=2),N.morphAttributes.color!==void 0&&(fe=3);let de,ee,ge,ye;if(ue){let Re=ks[ue];de=Re.vertexShader,ee=Re.fragmentShader}else{de=b.vertexShader,ee=b.fragmentShader;let Re=a.getVertexShaderStage(b),ht=a.getFragmentShaderStage(b);a.update(b,Re,ht),ge=Re.id,ye=ht.id}let Ce=n.getRenderTarget(),Me=n.state.buffers.depth.getReversed(),Xe=D.isInstancedMesh===!0,ct=D.isBatchedMesh===!0,We=!!b.map,_t=!!b.matcap,ft=!!z,ot=ft&&z.isPMREMTexture===!0,nn=!!b.aoMap,qt=!!b.lightMap,_n=!!b.bumpMap&&b.wireframe===!1,zt=!!b.normalMap,Fn=!!b.displacementMap,At=!!b.emissiveMap,Rn=!!b.metalnessMap,ln=!!b.roughnessMap,xn=b.anisotropy>0,k=b.clearcoat>0,Pe=b.diffuseRoughness>0,Je=b.dispersion>0,ut=b.retroreflectivity>0,we=b.iridescence>0,Wt=b.sheen>0,Ge=b.transmission>0,Ye=xn&&!!b.anisotropyMap,R=k&&!!b.clearcoatMap,S=k&&!!b.clearcoatNormalMap,$=k&&!!b.clearcoatRoughnessMap,he=Pe&&!!b.diffuseRoughnessMap,ae=we&&!!b.iridescenceMap,xe=we&&!!b.iridescenceThicknessMap,ve=Wt&&!!b.sheenColorMap,ne=Wt&&!!b.sheenRoughnessMap,se=!!b.specularMap,me=!!b.specularColorMap,U=!!b.specularIntensityMap,oe=Ge&&!!b.transmissionMap,ie=Ge&&!!b.thicknessMap,Te=!!b.gradientMap,_e=!!b.alphaMap,Se=b.alphaTest>0,$e=!!b.alphaHash,et=!!b.extensions,ce=Fs;b.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Be=ot?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,tt={shaderID:ue,shaderType:b.type,shaderName:b.name,vertexShader:de,fragmentShader:ee,defines:b.defines,customVertexShaderID:ge,customFragmentShaderID:ye,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:K,batching:ct,batchingColor:ct&&D._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&D.instanceColor!==null,instancingMorph:Xe&&D.morphTexture!==null,outputColorSpace:Ce===null?n.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:bt.workingColorSpace,alphaToCoverage:!!b.alphaToCoverage,map:We,matcap:_t,envMap:ft,envMapMode:ft&&z.mapping,envMapPMREM:ot,envMapMaxLod:ot?Be.length-1:null,envMapSize:ot?Be[0].width:null,aoMap:nn,lightMap:qt,bumpMap:_n,normalMap:zt,displacementMap:Fn,emissiveMap:At,normalMapObjectSpace:zt&&b.normalMapType===Jx,normalMapTangentSpace:zt&&b.normalMapType===Op,packedNormalMap:zt&&b.normalMapType===Op&&gR(b.normalMap.format),metalnessMap:Rn,roughnessMap:ln,anisotropy:xn,anisotropyMap:Ye,clearcoat:k,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:$,diffuseRoughness:Pe,diffuseRoughnessMap:he,dispersion:Je,retroreflection:ut,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:xe,sheen:Wt,sheenColorMap:ve,sheenRoughnessMap:ne,specularMap:se,specularColorMap:me,specularIntensityMap:U,transmission:Ge,transmissionMap:oe,thicknessMap:ie,gradientMap:Te,opaque:b.transparent===!1&&b.blending===da&&b.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:$e,combine:b.combine,mapUv:We&&p(b.map.channel),aoMapUv:nn&&p(b.aoMap.channel),lightMapUv:qt&&p(b.lightMap.channel),bumpMapUv:_n&&p(b.bumpMap.channel),normalMapUv:zt&&p(b.normalMap.channel),displacementMapUv:Fn&&p(b.displacementMap.channel),emissiveMapUv:At&&p(b.emissiveMap.channel),metalnessMapUv:Rn&&p(b.metalnessMap.channel),roughnessMapUv:ln&&p(b.roughnessMap.channel),anisotropyMapUv:Ye&&p(b.anisotropyMap.channel),clearcoatMapUv:R&&p(b.clearcoatMap.channel),clearcoatNormalMapUv:S&&p(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&p(b.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&p(b.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&p(b.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&p(b.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&p(b.sheenColorMap.channel),sheenRoughnessMapUv:ne&&p(b.sheenRoughnessMap.channel),specularMapUv:se&&p(b.specularMap.channel),specularColorMapUv:me&&p(b.specularColorMap.channel),specularIntensityMapUv:U&&p(b.specularIntensityMap.channel),transmissionMapUv:oe&&p(b.transmissionMap.channel),thicknessMapUv:ie&&p(b.thicknessMap.channel),alphaMapUv:_e&&p(b.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(zt||xn),vertexNormals:!!N.attributes.normal,vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(We||_e),fog:!!V,useFog:b.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:b.wireframe===!1&&(b.flatShading===!0||N.attributes.normal===void 0&&zt===!1&&(b.isMeshLambertMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isMeshPhysicalMaterial)),sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:Me,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:re,morphTextureStride:fe,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:G.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:b.dithering,shadowMapEnabled:n.shadowMap.enabled&&H.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:We&&b.map.isVideoTexture===!0&&bt.getTransfer(b.map.colorSpace)===Ft,decodeVideoTextureEmissive:At&&b.emissiveMap.isVideoTexture===!0&&bt.getTransfer(b.emissiveMap.colorSpace)===Ft,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===ji,flipSided:b.side===ui,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:et&&b.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&b.extensions.multiDraw===!0||ct)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function v(b){let A=[];if(b.shaderID?A.push(b.shaderID):(A.push(b.customVertexShaderID),A.push(b.customFragmentShaderID)),b.defines!==void 0)for(let H in b.defines)A.push(H),A.push(b.defines[H]);return b.isRawShaderMaterial===!1&&(_(A,b),g(A,b),A.push(n.outputColorSpace)),A.push(b.customProgramCacheKey),A.join()}function _(b,A){b.push(A.precision),b.push(A.outputColorSpace),b.push(A.envMapMode),b.push(A.envMapPMREM),b.push(A.envMapMaxLod),b.push(A.envMapSize),b.push(A.mapUv),b.push(A.alphaMapUv),b.push(A.lightMapUv),b.push(A.aoMapUv),b.push(A.bumpMapUv),b.push(A.normalMapUv),b.push(A.displacementMapUv),b.push(A.emissiveMapUv),b.push(A.metalnessMapUv),b.push(A.roughnessMapUv),b.push(A.anisotropyMapUv),b.push(A.clearcoatMapUv),b.push(A.clearcoatNormalMapUv),b.push(A.clearcoatRoughnessMapUv),b.push(A.diffuseRoughnessMapUv),b.push(A.iridescenceMapUv),b.push(A.iridescenceThicknessMapUv),b.push(A.sheenColorMapUv),b.push(A.sheenRoughnessMapUv),b.push(A.specularMapUv),b.push(A.specularColorMapUv),b.push(A.specularIntensityMapUv),b.push(A.transmissionMapUv),b.push(A.thicknessMapUv),b.push(A.combine),b.push(A.fogExp2),b.push(A.sizeAttenuation),b.push(A.morphTargetsCount),b.push(A.numSunLights),b.push(A.numDirLights),b.push(A.numPointLights),b.push(A.numSpotLights),b.push(A.numSpotLightMaps),b.push(A.numHemiLights),b.push(A.numRectAreaLights),b.push(A.numSunLightShadows),b.push(A.numDirLightShadows),b.push(A.numPointLightShadows),b.push(A.numSpotLightShadows),b.push(A.numSpotLightShadowsWithMaps),b.push(A.numLightProbes),b.push(A.numLightProbeGrids),b.push(A.shadowMapType),b.push(A.toneMapping),b.push(A.numClippingPlanes),b.push(A.numClipIntersection),b.push(A.depthPacking)}function g(b,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),b.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),b.push(o.mask)}function y(b){let A=d[b.type],H;if(A){let F=ks[A];H=uy.clone(F.uniforms)}else H=b.uniforms;return H}function E(b,A){let H=u.get(A);return H!==void 0?++H.usedTimes:(H=new pR(n,A,b,s),c.push(H),u.set(A,H)),H}function M(b){if(--b.usedTimes===0){let A=c.indexOf(b);c[A]=c[c.length-1],c.pop(),u.delete(b.cacheKey),b.destroy()}}function I(b){a.remove(b)}function C(){a.dispose()}return{getParameters:m,getProgramCacheKey:v,getUniforms:y,acquireProgram:E,releaseProgram:M,releaseShaderCache:I,programs:c,dispose:C}}function xR(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function yR(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Py(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Iy(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let p=0;return d.isInstancedMesh&&(p+=2),d.isSkinnedMesh&&(p+=1),p}function a(d,p,m,v,_,g){let y=n[e];return y===void 0?(y={id:d.id,object:d,geometry:p,material:m,materialVariant:o(d),groupOrder:v,renderOrder:d.renderOrder,z:_,group:g},n[e]=y):(y.id=d.id,y.object=d,y.geometry=p,y.material=m,y.materialVariant=o(d),y.groupOrder=v,y.renderOrder=d.renderOrder,y.z=_,y.group=g),e++,y}function l(d,p,m,v,_,g,y){y.reversedDepth===!0&&(_=-_);let E=a(d,p,m,v,_,g);m.transmission>0?i.push(E):m.transparent===!0?s.push(E):t.push(E)}function c(d,p,m,v,_,g){let y=a(d,p,m,v,_,g);m.transmission>0?i.unshift(y):m.transparent===!0?s.unshift(y):t.unshift(y)}function u(d,p){t.length>1&&t.sort(d||yR),i.length>1&&i.sort(p||Py),s.length>1&&s.sort(p||Py)}function f(){for(let d=e,p=n.length;d<p;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function vR(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Iy,n.set(i,[o])):s>=r.length?(o=new Iy,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function bR(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new X,color:new Ct};break;case"SpotLight":t={position:new X,direction:new X,color:new Ct,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new X,color:new Ct,distance:0,decay:0};break;case"HemisphereLight":t={direction:new X,skyColor:new Ct,groundColor:new Ct};break;case"RectAreaLight":t={color:new Ct,position:new X,halfWidth:new X,halfHeight:new X};break}return n[e.id]=t,t}}}function SR(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Et};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Et};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Et,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var MR=0;function wR(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function TR(n){let e=new bR,t=SR(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new X);let s=new X,r=new Jt,o=new Jt;function a(c){let u=0,f=0,d=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let p=0,m=0,v=0,_=0,g=0,y=0,E=0,M=0,I=0,C=0,b=0,A=0,H=0,F=0;c.sort(wR);for(let G=0,V=c.length;G<V;G++){let N=c[G],W=N.color,Z=N.intensity,z=N.distance,ue=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Dr?ue=N.shadow.map.texture:ue=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=W.r*Z,f+=W.g*Z,d+=W.b*Z;else if(N.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(N.sh.coefficients[K],Z);F++}else if(N.isSunLight){let K=e.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,re=t.get(N);re.shadowIntensity=Q.intensity,re.shadowBias=Q.bias,re.shadowNormalBias=Q.normalBias,re.shadowRadius=Q.radius,re.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[m]=re,i.sunShadowMap[m]=ue;let fe=Q.getViewportCount();for(let de=0;de<fe;de++)i.sunShadowMatrix[v+de]=Q.getMatrix(de),i.sunShadowCascade[v+de]=Q._cascadeData[de];v+=fe,m++}i.sun[p]=K,p++}else if(N.isDirectionalLight){let K=e.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,re=t.get(N);re.shadowIntensity=Q.intensity,re.shadowBias=Q.bias,re.shadowNormalBias=Q.normalBias,re.shadowRadius=Q.radius,re.shadowMapSize=Q.mapSize,i.directionalShadow[_]=re,i.directionalShadowMap[_]=ue,i.directionalShadowMatrix[_]=N.shadow.matrix,I++}i.directional[_]=K,_++}else if(N.isSpotLight){let K=e.get(N);K.position.setFromMatrixPosition(N.matrixWorld),K.color.copy(W).multiplyScalar(Z),K.distance=z,K.coneCos=Math.cos(N.angle),K.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),K.decay=N.decay,i.spot[y]=K;let Q=N.shadow;if(N.map&&(i.spotLightMap[A]=N.map,A++,Q.updateMatrices(N),N.castShadow&&H++),i.spotLightMatrix[y]=Q.matrix,N.castShadow){let re=t.get(N);re.shadowIntensity=Q.intensity,re.shadowBias=Q.bias,re.shadowNormalBias=Q.normalBias,re.shadowRadius=Q.radius,re.shadowMapSize=Q.mapSize,i.spotShadow[y]=re,i.spotShadowMap[y]=ue,b++}y++}else if(N.isRectAreaLight){let K=e.get(N);K.color.copy(W).multiplyScalar(Z),K.halfWidth.set(N.width*.5,0,0),K.halfHeight.set(0,N.height*.5,0),i.rectArea[E]=K,E++}else if(N.isPointLight){let K=e.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),K.distance=N.distance,K.decay=N.decay,N.castShadow){let Q=N.shadow,re=t.get(N);re.shadowIntensity=Q.intensity,re.shadowBias=Q.bias,re.shadowNormalBias=Q.normalBias,re.shadowRadius=Q.radius,re.shadowMapSize=Q.mapSize,re.shadowCameraNear=Q.camera.near,re.shadowCameraFar=Q.camera.far,i.pointShadow[g]=re,i.pointShadowMap[g]=ue,i.pointShadowMatrix[g]=N.shadow.matrix,C++}i.point[g]=K,g++}else if(N.isHemisphereLight){let K=e.get(N);K.skyColor.copy(N.color).multiplyScalar(Z),K.groundColor.copy(N.groundColor).multiplyScalar(Z),i.hemi[M]=K,M++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=d;let D=i.hash;(D.sunLength!==p||D.directionalLength!==_||D.pointLength!==g||D.spotLength!==y||D.rectAreaLength!==E||D.hemiLength!==M||D.numSunShadows!==m||D.numDirectionalShadows!==I||D.numPointShadows!==C||D.numSpotShadows!==b||D.numSpotMaps!==A||D.numLightProbes!==F)&&(i.sun.length=p,i.directional.length=_,i.spot.length=y,i.rectArea.length=E,i.point.length=g,i.hemi.length=M,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=I,i.directionalShadowMap.length=I,i.directionalShadowMatrix.length=I,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=b,i.spotShadowMap.length=b,i.spotLightMatrix.length=b+A-H,i.spotLightMap.length=A,i.numSpotLightShadowsWithMaps=H,i.numLightProbes=F,D.sunLength=p,D.directionalLength=_,D.pointLength=g,D.spotLength=y,D.rectAreaLength=E,D.hemiLength=M,D.numSunShadows=m,D.numDirectionalShadows=I,D.numPointShadows=C,D.numSpotShadows=b,D.numSpotMaps=A,D.numLightProbes=F,i.version=MR++)}function l(c,u){let f=0,d=0,p=0,m=0,v=0,_=0,g=u.matrixWorldInverse;for(let y=0,E=c.length;y<E;y++){let M=c[y];if(M.isSunLight){let I=i.sun[f];I.direction.setFromMatrixPosition(M.matrixWorld),I.direction.transformDirection(g),f++}else if(M.isDirectionalLight){let I=i.directional[d];I.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(g),d++}else if(M.isSpotLight){let I=i.spot[m];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(g),I.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(g),m++}else if(M.isRectAreaLight){let I=i.rectArea[v];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(g),o.identity(),r.copy(M.matrixWorld),r.premultiply(g),o.extractRotation(r),I.halfWidth.set(M.width*.5,0,0),I.halfHeight.set(0,M.height*.5,0),I.halfWidth.applyMatrix4(o),I.halfHeight.applyMatrix4(o),v++}else if(M.isPointLight){let I=i.point[p];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(g),p++}else if(M.isHemisphereLight){let I=i.hemi[_];I.direction.setFromMatrixPosition(M.matrixWorld),I.direction.transformDirection(g),_++}}}return{setup:a,setupView:l,state:i}}function Ly(n){let e=new TR(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,d)=>f.priority-d.priority||f.id-d.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function AR(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Ly(n),e.set(s,[a])):r>=o.length?(a=new Ly(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var ER=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,CR=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,RR=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],PR=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],Dy=new Jt,Rl=new X,Yp=new X;function IR(n,e,t){let i=new Qr,s=new Et,r=new Et,o=new an,a=new Iu,l=new Lu,c={},u=t.maxTextureSize,f={[Lr]:ui,[ui]:Lr,[ji]:ji},d=new Ns({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Et},radius:{value:4}},vertexShader:ER,fragmentShader:CR}),p=d.clone();p.defines.HORIZONTAL_PASS=1;let m=new Ki;m.setAttribute("position",new fn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Xn(m,d),_=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=vl;let g=this.type;this.render=function(C,b,A){if(_.enabled===!1||_.autoUpdate===!1&&_.needsUpdate===!1||C.length===0)return;this.type===Ax&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=vl);let H=n.getRenderTarget(),F=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),G=n.state;G.setBlending(no),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let V=g!==this.type;V&&b.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=C.length;N<W;N++){let Z=C[N],z=Z.shadow;if(z===void 0){Ke("WebGLShadowMap:",Z,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let ue=z.getFrameExtents();s.multiply(ue),r.copy(z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ue.x),s.x=r.x*ue.x,z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ue.y),s.y=r.y*ue.y,z.mapSize.y=r.y));let K=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=K,z.map===null||V===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===ha){if(Z.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new Li(s.x,s.y,{format:Dr,type:ps,minFilter:ci,magFilter:ci,generateMipmaps:!1}),z.map.texture.name=Z.name+".shadowMap",z.map.depthTexture=new nr(s.x,s.y,Ui),z.map.depthTexture.name=Z.name+".shadowMapDepth",z.map.depthTexture.format=tr,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Hn,z.map.depthTexture.magFilter=Hn}else Z.isPointLight?(z.map=new Il(s.x),z.map.depthTexture=new ml(s.x,fs)):(z.map=new Li(s.x,s.y),z.map.depthTexture=new nr(s.x,s.y,fs)),z.map.depthTexture.name=Z.name+".shadowMap",z.map.depthTexture.format=tr,this.type===vl?(z.map.depthTexture.compareFunction=K?Vp:Bp,z.map.depthTexture.minFilter=ci,z.map.depthTexture.magFilter=ci):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Hn,z.map.depthTexture.magFilter=Hn);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Q=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();Z.isPointLight!==!0&&z.updateMatrices(Z,A);let re=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:A.layers;for(let fe=0;fe<Q;fe++){let de=z.getCamera(fe);if(Z.isPointLight){let ee=z.camera,ge=z.matrix,ye=Z.distance||ee.far;ye!==ee.far&&(ee.far=ye,ee.updateProjectionMatrix()),Rl.setFromMatrixPosition(Z.matrixWorld),ee.position.copy(Rl),Yp.copy(ee.position),Yp.add(RR[fe]),ee.up.copy(PR[fe]),ee.lookAt(Yp),ee.updateMatrixWorld(),ge.makeTranslation(-Rl.x,-Rl.y,-Rl.z),Dy.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),z._frustum.setFromProjectionMatrix(Dy,ee.coordinateSystem,ee.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(z.map),n.clear());let ee=z.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),G.viewport(o)}i=z.getFrustum(fe),M(b,A,de,Z,re,this.type)}z.isPointLightShadow!==!0&&this.type===ha&&y(z,A),z.needsUpdate=!1}g=this.type,_.needsUpdate=!1,n.setRenderTarget(H,F,D)};function y(C,b){let A=e.update(v);d.defines.VSM_SAMPLES!==C.blurSamples&&(d.defines.VSM_SAMPLES=C.blurSamples,p.defines.VSM_SAMPLES=C.blurSamples,d.needsUpdate=!0,p.needsUpdate=!0),C.mapPass===null?C.mapPass=new Li(s.x,s.y,{format:Dr,type:ps}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),d.uniforms.shadow_pass.value=C.map.depthTexture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(b,null,A,d,v,null),p.uniforms.shadow_pass.value=C.mapPass.texture,p.uniforms.resolution.value.set(C.map.width,C.map.height),p.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(b,null,A,p,v,null)}function E(C,b,A,H){let F=null,D=A.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(D!==void 0)F=D;else if(F=A.isPointLight===!0?l:a,n.localClippingEnabled&&b.clipShadows===!0&&Array.isArray(b.clippingPlanes)&&b.clippingPlanes.length!==0||b.displacementMap&&b.displacementScale!==0||b.alphaMap&&b.alphaTest>0||b.map&&b.alphaTest>0||b.alphaToCoverage===!0){let G=F.uuid,V=b.uuid,N=c[G];N===void 0&&(N={},c[G]=N);let W=N[V];W===void 0&&(W=F.clone(),N[V]=W,b.addEventListener("dispose",I)),F=W}if(F.visible=b.visible,F.wireframe=b.wireframe,H===ha?F.side=b.shadowSide!==null?b.shadowSide:b.side:F.side=b.shadowSide!==null?b.shadowSide:f[b.side],F.alphaMap=b.alphaMap,F.alphaTest=b.alphaToCoverage===!0?.5:b.alphaTest,F.map=b.map,F.clipShadows=b.clipShadows,F.clippingPlanes=b.clippingPlanes,F.clipIntersection=b.clipIntersection,F.displacementMap=b.displacementMap,F.displacementScale=b.displacementScale,F.displacementBias=b.displacementBias,F.wireframeLinewidth=b.wireframeLinewidth,F.linewidth=b.linewidth,A.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let G=n.properties.get(F);G.light=A}return F}function M(C,b,A,H,F,D){if(C.visible===!1)return;if(C.layers.test(F)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&D===ha)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,C.matrixWorld);let N=e.update(C),W=C.material;if(Array.isArray(W)){let Z=N.groups;for(let z=0,ue=Z.length;z<ue;z++){let K=Z[z],Q=W[K.materialIndex];if(Q&&Q.visible){let re=E(C,Q,H,D);C.onBeforeShadow(n,C,b,A,N,re,K),n.renderBufferDirect(A,null,N,re,C,K),C.onAfterShadow(n,C,b,A,N,re,K)}}}else if(W.visible){let Z=E(C,W,H,D);C.onBeforeShadow(n,C,b,A,N,Z,null),n.renderBufferDirect(A,null,N,Z,C,null),C.onAfterShadow(n,C,b,A,N,Z,null)}}let V=C.children;for(let N=0,W=V.length;N<W;N++)M(V[N],b,A,H,F,D)}function I(C){C.target.removeEventListener("dispose",I);for(let A in c){let H=c[A],F=C.target.uuid;F in H&&(H[F].dispose(),delete H[F])}}}function LR(n,e){function t(){let U=!1,oe=new an,ie=null,Te=new an(0,0,0,0);return{setMask:function(_e){ie!==_e&&!U&&(n.colorMask(_e,_e,_e,_e),ie=_e)},setLocked:function(_e){U=_e},setClear:function(_e,Se,$e,et,ce){ce===!0&&(_e*=et,Se*=et,$e*=et),oe.set(_e,Se,$e,et),Te.equals(oe)===!1&&(n.clearColor(_e,Se,$e,et),Te.copy(oe))},reset:function(){U=!1,ie=null,Te.set(-1,0,0,0)}}}function i(){let U=!1,oe=!1,ie=null,Te=null,_e=null;return{setReversed:function(Se){if(oe!==Se){let $e=e.get("EXT_clip_control");Se?$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.ZERO_TO_ONE_EXT):$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.NEGATIVE_ONE_TO_ONE_EXT),oe=Se;let et=_e;_e=null,this.setClear(et)}},getReversed:function(){return oe},setTest:function(Se){Se?Me(n.DEPTH_TEST):Xe(n.DEPTH_TEST)},setMask:function(Se){ie!==Se&&!U&&(n.depthMask(Se),ie=Se)},setFunc:function(Se){if(oe&&(Se=ry[Se]),Te!==Se){switch(Se){case uu:n.depthFunc(n.NEVER);break;case hu:n.depthFunc(n.ALWAYS);break;case du:n.depthFunc(n.LESS);break;case na:n.depthFunc(n.LEQUAL);break;case fu:n.depthFunc(n.EQUAL);break;case pu:n.depthFunc(n.GEQUAL);break;case mu:n.depthFunc(n.GREATER);break;case gu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=Se}},setLocked:function(Se){U=Se},setClear:function(Se){_e!==Se&&(_e=Se,oe&&(Se=1-Se),n.clearDepth(Se))},reset:function(){U=!1,ie=null,Te=null,_e=null,oe=!1}}}function s(){let U=!1,oe=null,ie=null,Te=null,_e=null,Se=null,$e=null,et=null,ce=null;return{setTest:function(Be){U||(Be?Me(n.STENCIL_TEST):Xe(n.STENCIL_TEST))},setMask:function(Be){oe!==Be&&!U&&(n.stencilMask(Be),oe=Be)},setFunc:function(Be,tt,Re){(ie!==Be||Te!==tt||_e!==Re)&&(n.stencilFunc(Be,tt,Re),ie=Be,Te=tt,_e=Re)},setOp:function(Be,tt,Re){(Se!==Be||$e!==tt||et!==Re)&&(n.stencilOp(Be,tt,Re),Se=Be,$e=tt,et=Re)},setLocked:function(Be){U=Be},setClear:function(Be){ce!==Be&&(n.clearStencil(Be),ce=Be)},reset:function(){U=!1,oe=null,ie=null,Te=null,_e=null,Se=null,$e=null,et=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},d={},p=new WeakMap,m=[],v=null,_=!1,g=null,y=null,E=null,M=null,I=null,C=null,b=null,A=new Ct(0,0,0),H=0,F=!1,D=null,G=null,V=null,N=null,W=null,Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ue=0,K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(ue=parseFloat(/^WebGL (\d)/.exec(K)[1]),z=ue>=1):K.indexOf("OpenGL ES")!==-1&&(ue=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),z=ue>=2);let Q=null,re={},fe=n.getParameter(n.SCISSOR_BOX),de=n.getParameter(n.VIEWPORT),ee=new an().fromArray(fe),ge=new an().fromArray(de);function ye(U,oe,ie,Te){let _e=new Uint8Array(4),Se=n.createTexture();n.bindTexture(U,Se),n.texParameteri(U,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(U,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $e=0;$e<ie;$e++)U===n.TEXTURE_3D||U===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(oe+$e,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Se}let Ce={};Ce[n.TEXTURE_2D]=ye(n.TEXTURE_2D,n.TEXTURE_2D,1),Ce[n.TEXTURE_CUBE_MAP]=ye(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[n.TEXTURE_2D_ARRAY]=ye(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ce[n.TEXTURE_3D]=ye(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(n.DEPTH_TEST),o.setFunc(na),_n(!1),zt(gp),Me(n.CULL_FACE),nn(no);function Me(U){u[U]!==!0&&(n.enable(U),u[U]=!0)}function Xe(U){u[U]!==!1&&(n.disable(U),u[U]=!1)}function ct(U,oe){return d[U]!==oe?(n.bindFramebuffer(U,oe),d[U]=oe,U===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=oe),U===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function We(U,oe){let ie=m,Te=!1;if(U){ie=p.get(oe),ie===void 0&&(ie=[],p.set(oe,ie));let _e=U.textures;if(ie.length!==_e.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,$e=_e.length;Se<$e;Se++)ie[Se]=n.COLOR_ATTACHMENT0+Se;ie.length=_e.length,Te=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Te=!0);Te&&n.drawBuffers(ie)}function _t(U){return v!==U?(n.useProgram(U),v=U,!0):!1}let ft={[io]:n.FUNC_ADD,[Cx]:n.FUNC_SUBTRACT,[Rx]:n.FUNC_REVERSE_SUBTRACT};ft[Px]=n.MIN,ft[Ix]=n.MAX;let ot={[Lx]:n.ZERO,[Dx]:n.ONE,[Nx]:n.SRC_COLOR,[vp]:n.SRC_ALPHA,[Vx]:n.SRC_ALPHA_SATURATE,[Ox]:n.DST_COLOR,[Ux]:n.DST_ALPHA,[Fx]:n.ONE_MINUS_SRC_COLOR,[bp]:n.ONE_MINUS_SRC_ALPHA,[Bx]:n.ONE_MINUS_DST_COLOR,[kx]:n.ONE_MINUS_DST_ALPHA,[zx]:n.CONSTANT_COLOR,[Gx]:n.ONE_MINUS_CONSTANT_COLOR,[Hx]:n.CONSTANT_ALPHA,[Wx]:n.ONE_MINUS_CONSTANT_ALPHA};function nn(U,oe,ie,Te,_e,Se,$e,et,ce,Be){if(U===no){_===!0&&(Xe(n.BLEND),_=!1);return}if(_===!1&&(Me(n.BLEND),_=!0),U!==Ex){if(U!==g||Be!==F){if((y!==io||I!==io)&&(n.blendEquation(n.FUNC_ADD),y=io,I=io),Be)switch(U){case da:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case _p:n.blendFunc(n.ONE,n.ONE);break;case xp:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case yp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:st("WebGLState: Invalid blending: ",U);break}else switch(U){case da:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case _p:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case xp:st("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case yp:st("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:st("WebGLState: Invalid blending: ",U);break}E=null,M=null,C=null,b=null,A.set(0,0,0),H=0,g=U,F=Be}return}_e=_e||oe,Se=Se||ie,$e=$e||Te,(oe!==y||_e!==I)&&(n.blendEquationSeparate(ft[oe],ft[_e]),y=oe,I=_e),(ie!==E||Te!==M||Se!==C||$e!==b)&&(n.blendFuncSeparate(ot[ie],ot[Te],ot[Se],ot[$e]),E=ie,M=Te,C=Se,b=$e),(et.equals(A)===!1||ce!==H)&&(n.blendColor(et.r,et.g,et.b,ce),A.copy(et),H=ce),g=U,F=!1}function qt(U,oe){U.side===ji?Xe(n.CULL_FACE):Me(n.CULL_FACE);let ie=U.side===ui;oe&&(ie=!ie),_n(ie),U.blending===da&&U.transparent===!1?nn(no):nn(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let Te=U.stencilWrite;a.setTest(Te),Te&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),At(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?Me(n.SAMPLE_ALPHA_TO_COVERAGE):Xe(n.SAMPLE_ALPHA_TO_COVERAGE)}function _n(U){D!==U&&(U?n.frontFace(n.CW):n.frontFace(n.CCW),D=U)}function zt(U){U!==wx?(Me(n.CULL_FACE),U!==G&&(U===gp?n.cullFace(n.BACK):U===Tx?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Xe(n.CULL_FACE),G=U}function Fn(U){U!==V&&(z&&n.lineWidth(U),V=U)}function At(U,oe,ie){U?(Me(n.POLYGON_OFFSET_FILL),(N!==oe||W!==ie)&&(N=oe,W=ie,o.getReversed()&&(oe=-oe,ie=-ie),n.polygonOffset(oe,ie))):Xe(n.POLYGON_OFFSET_FILL)}function Rn(U){U?Me(n.SCISSOR_TEST):Xe(n.SCISSOR_TEST)}function ln(U){U===void 0&&(U=n.TEXTURE0+Z-1),Q!==U&&(n.activeTexture(U),Q=U)}function xn(U,oe,ie){ie===void 0&&(Q===null?ie=n.TEXTURE0+Z-1:ie=Q);let Te=re[ie];Te===void 0&&(Te={type:void 0,texture:void 0},re[ie]=Te),(Te.type!==U||Te.texture!==oe)&&(Q!==ie&&(n.activeTexture(ie),Q=ie),n.bindTexture(U,oe||Ce[U]),Te.type=U,Te.texture=oe)}function k(){let U=re[Q];U!==void 0&&U.type!==void 0&&(n.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(U){st("WebGLState:",U)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(U){st("WebGLState:",U)}}function ut(){try{n.texSubImage2D(...arguments)}catch(U){st("WebGLState:",U)}}function we(){try{n.texSubImage3D(...arguments)}catch(U){st("WebGLState:",U)}}function Wt(){try{n.compressedTexSubImage2D(...arguments)}catch(U){st("WebGLState:",U)}}function Ge(){try{n.compressedTexSubImage3D(...arguments)}catch(U){st("WebGLState:",U)}}function Ye(){try{n.texStorage2D(...arguments)}catch(U){st("WebGLState:",U)}}function R(){try{n.texStorage3D(...arguments)}catch(U){st("WebGLState:",U)}}function S(){try{n.texImage2D(...arguments)}catch(U){st("WebGLState:",U)}}function $(){try{n.texImage3D(...arguments)}catch(U){st("WebGLState:",U)}}function he(U){return f[U]!==void 0?f[U]:n.getParameter(U)}function ae(U,oe){f[U]!==oe&&(n.pixelStorei(U,oe),f[U]=oe)}function xe(U){ee.equals(U)===!1&&(n.scissor(U.x,U.y,U.z,U.w),ee.copy(U))}function ve(U){ge.equals(U)===!1&&(n.viewport(U.x,U.y,U.z,U.w),ge.copy(U))}function ne(U,oe){let ie=c.get(oe);ie===void 0&&(ie=new WeakMap,c.set(oe,ie));let Te=ie.get(U);Te===void 0&&(Te=n.getUniformBlockIndex(oe,U.name),n.uniformBlockBinding(oe,Te,Te),ie.set(U,Te))}function se(U,oe,ie){let _e=c.get(oe).get(U);l[_e]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,ie),l[_e]=ie)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},Q=null,re={},d={},l={},p=new WeakMap,m=[],v=null,_=!1,g=null,y=null,E=null,M=null,I=null,C=null,b=null,A=new Ct(0,0,0),H=0,F=!1,D=null,G=null,V=null,N=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),ge.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:Xe,bindFramebuffer:ct,drawBuffers:We,useProgram:_t,setBlending:nn,setMaterial:qt,setFlipSided:_n,setCullFace:zt,setLineWidth:Fn,setPolygonOffset:At,setScissorTest:Rn,activeTexture:ln,bindTexture:xn,unbindTexture:k,compressedTexImage2D:Pe,compressedTexImage3D:Je,texImage2D:S,texImage3D:$,pixelStorei:ae,getParameter:he,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:Ye,texStorage3D:R,texSubImage2D:ut,texSubImage3D:we,compressedTexSubImage2D:Wt,compressedTexSubImage3D:Ge,scissor:xe,viewport:ve,reset:me}}function DR(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Et,u=new WeakMap,f=new Set,d,p=new WeakMap,m=new Set,v=new FinalizationRegistry(R=>m.delete(R)),_=!1;try{_=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,S){return _?new OffscreenCanvas(R,S):rl("canvas")}function y(R,S,$){let he=1,ae=Ye(R);if((ae.width>$||ae.height>$)&&(he=$/Math.max(ae.width,ae.height)),he<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let xe=Math.floor(he*ae.width),ve=Math.floor(he*ae.height);d===void 0&&(d=g(xe,ve));let ne=S?g(xe,ve):d;return ne.width=xe,ne.height=ve,ne.getContext("2d").drawImage(R,0,0,xe,ve),Ke("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+xe+"x"+ve+")."),ne}else return"data"in R&&Ke("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),R;return R}function E(R){return R.generateMipmaps}function M(R){n.generateMipmap(R)}function I(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(R,S,$,he,ae,xe=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ve;he&&(ve=e.get("EXT_texture_norm16"),ve||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=S;if(S===n.RED&&($===n.FLOAT&&(ne=n.R32F),$===n.HALF_FLOAT&&(ne=n.R16F),$===n.UNSIGNED_BYTE&&(ne=n.R8),$===n.UNSIGNED_SHORT&&ve&&(ne=ve.R16_EXT),$===n.SHORT&&ve&&(ne=ve.R16_SNORM_EXT)),S===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.R8UI),$===n.UNSIGNED_SHORT&&(ne=n.R16UI),$===n.UNSIGNED_INT&&(ne=n.R32UI),$===n.BYTE&&(ne=n.R8I),$===n.SHORT&&(ne=n.R16I),$===n.INT&&(ne=n.R32I)),S===n.RG&&($===n.FLOAT&&(ne=n.RG32F),$===n.HALF_FLOAT&&(ne=n.RG16F),$===n.UNSIGNED_BYTE&&(ne=n.RG8),$===n.UNSIGNED_SHORT&&ve&&(ne=ve.RG16_EXT),$===n.SHORT&&ve&&(ne=ve.RG16_SNORM_EXT)),S===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.RG8UI),$===n.UNSIGNED_SHORT&&(ne=n.RG16UI),$===n.UNSIGNED_INT&&(ne=n.RG32UI),$===n.BYTE&&(ne=n.RG8I),$===n.SHORT&&(ne=n.RG16I),$===n.INT&&(ne=n.RG32I)),S===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.RGB8UI),$===n.UNSIGNED_SHORT&&(ne=n.RGB16UI),$===n.UNSIGNED_INT&&(ne=n.RGB32UI),$===n.BYTE&&(ne=n.RGB8I),$===n.SHORT&&(ne=n.RGB16I),$===n.INT&&(ne=n.RGB32I)),S===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(ne=n.RGBA16UI),$===n.UNSIGNED_INT&&(ne=n.RGBA32UI),$===n.BYTE&&(ne=n.RGBA8I),$===n.SHORT&&(ne=n.RGBA16I),$===n.INT&&(ne=n.RGBA32I)),S===n.RGB&&($===n.UNSIGNED_SHORT&&ve&&(ne=ve.RGB16_EXT),$===n.SHORT&&ve&&(ne=ve.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(ne=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(ne=n.R11F_G11F_B10F)),S===n.RGBA){let se=xe?il:bt.getTransfer(ae);$===n.FLOAT&&(ne=n.RGBA32F),$===n.HALF_FLOAT&&(ne=n.RGBA16F),$===n.UNSIGNED_BYTE&&(ne=se===Ft?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&ve&&(ne=ve.RGBA16_EXT),$===n.SHORT&&ve&&(ne=ve.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(ne=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(ne=n.RGB5_A1)}return(ne===n.R16F||ne===n.R32F||ne===n.RG16F||ne===n.RG32F||ne===n.RGBA16F||ne===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function b(R,S){let $;return R?S===null||S===fs||S===ro?$=n.DEPTH24_STENCIL8:S===Ui?$=n.DEPTH32F_STENCIL8:S===pa&&($=n.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===fs||S===ro?$=n.DEPTH_COMPONENT24:S===Ui?$=n.DEPTH_COMPONENT32F:S===pa&&($=n.DEPTH_COMPONENT16),$}function A(R,S){return E(R)===!0||R.isFramebufferTexture&&R.minFilter!==Hn&&R.minFilter!==ci?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function H(R){let S=new WeakRef(R);i.get(R).__ref=S,m.add(S),v.register(R,S,S)}function F(R){let S=i.get(R).__ref;S!==void 0&&(m.delete(S),v.unregister(S))}function D(R){V(R.target)}function G(R){N(R.target)}function V(R){R.removeEventListener("dispose",D),F(R),Z(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function N(R){R.removeEventListener("dispose",G),F(R),ue(R)}function W(){for(let R of m){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?N(S):V(S))}m.clear(),f.clear()}function Z(R){let S=i.get(R);if(S.__webglInit===void 0)return;let $=R.source,he=p.get($);if(he){let ae=he[S.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&z(R),Object.keys(he).length===0&&p.delete($)}i.remove(R)}function z(R){let S=i.get(R);n.deleteTexture(S.__webglTexture);let $=R.source,he=p.get($);delete he[S.__cacheKey],o.memory.textures--}function ue(R){let S=i.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let $=R.depthTexture;if($&&$.renderTarget===R&&V($),R.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(S.__webglFramebuffer[ae]))for(let xe=0;xe<S.__webglFramebuffer[ae].length;xe++)n.deleteFramebuffer(S.__webglFramebuffer[ae][xe]);else n.deleteFramebuffer(S.__webglFramebuffer[ae]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[ae])}else{if(Array.isArray(S.__webglFramebuffer))for(let ae=0;ae<S.__webglFramebuffer.length;ae++)n.deleteFramebuffer(S.__webglFramebuffer[ae]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ae=0;ae<S.__webglColorRenderbuffer.length;ae++)S.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[ae]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let he=R.textures;for(let ae=0,xe=he.length;ae<xe;ae++){let ve=i.get(he[ae]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(he[ae])}i.remove(R)}let K=0;function Q(){K=0}function re(){return K}function fe(R){K=R}function de(){let R=K;return R>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,R}function ee(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function ge(R,S){let $=i.get(R);if(R.isVideoTexture&&Wt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&$.__version!==R.version){let he=R.image;if(he===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{qt($,R,S);return}}else R.isExternalTexture&&($.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+S)}function ye(R,S){let $=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){qt($,R,S);return}else R.isExternalTexture&&($.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+S)}function Ce(R,S){let $=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){qt($,R,S);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+S)}function Me(R,S){let $=i.get(R);if(R.version>0&&$.__version!==R.version){_n($,R,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+S)}let Xe={[_u]:n.REPEAT,[Is]:n.CLAMP_TO_EDGE,[xu]:n.MIRRORED_REPEAT},ct={[Hn]:n.NEAREST,[qx]:n.NEAREST_MIPMAP_NEAREST,[bl]:n.NEAREST_MIPMAP_LINEAR,[ci]:n.LINEAR,[qu]:n.LINEAR_MIPMAP_NEAREST,[ir]:n.LINEAR_MIPMAP_LINEAR},We={[Kx]:n.NEVER,[zp]:n.ALWAYS,[jx]:n.LESS,[Bp]:n.LEQUAL,[Qx]:n.EQUAL,[Vp]:n.GEQUAL,[ey]:n.GREATER,[ty]:n.NOTEQUAL};function _t(R,S){if(S.type===Ui&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===ci||S.magFilter===qu||S.magFilter===bl||S.magFilter===ir||S.minFilter===ci||S.minFilter===qu||S.minFilter===bl||S.minFilter===ir)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,Xe[S.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,Xe[S.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,Xe[S.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ct[S.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ct[S.minFilter]),S.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,We[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Hn||S.minFilter!==bl&&S.minFilter!==ir||S.type===Ui&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function ft(R,S){let $=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",D),H(S));let he=S.source,ae=p.get(he);ae===void 0&&(ae={},p.set(he,ae));let xe=ee(S);if(xe!==R.__cacheKey){ae[xe]===void 0&&(ae[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ae[xe].usedTimes++;let ve=ae[R.__cacheKey];ve!==void 0&&(ae[R.__cacheKey].usedTimes--,ve.usedTimes===0&&z(S)),R.__cacheKey=xe,R.__webglTexture=ae[xe].texture}return $}function ot(R,S,$){return Math.floor(Math.floor(R/$)/S)}function nn(R,S,$,he){let xe=R.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,$,he,S.data);else{xe.sort((U,oe)=>U.start-oe.start);let ve=0;for(let U=1;U<xe.length;U++){let oe=xe[ve],ie=xe[U],Te=oe.start+oe.count,_e=ot(ie.start,S.width,4),Se=ot(oe.start,S.width,4);ie.start<=Te+1&&_e===Se&&ot(ie.start+ie.count-1,S.width,4)===_e?oe.count=Math.max(oe.count,ie.start+ie.count-oe.start):(++ve,xe[ve]=ie)}xe.length=ve+1;let ne=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let U=0,oe=xe.length;U<oe;U++){let ie=xe[U],Te=Math.floor(ie.start/4),_e=Math.ceil(ie.count/4),Se=Te%S.width,$e=Math.floor(Te/S.width),et=_e,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,$e),t.texSubImage2D(n.TEXTURE_2D,0,Se,$e,et,ce,$,he,S.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ne),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function qt(R,S,$){let he=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(he=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(he=n.TEXTURE_3D);let ae=ft(R,S),xe=S.source;t.bindTexture(he,R.__webglTexture,n.TEXTURE0+$);let ve=i.get(xe);if(xe.version!==ve.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ce=bt.getPrimaries(bt.workingColorSpace),Be=S.colorSpace===rr?null:bt.getPrimaries(S.colorSpace),tt=S.colorSpace===rr||ce===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let se=y(S.image,!1,s.maxTextureSize);se=Ge(S,se);let me=r.convert(S.format,S.colorSpace),U=r.convert(S.type),oe=C(S.internalFormat,me,U,S.normalized,S.colorSpace,S.isVideoTexture);_t(he,S);let ie,Te=S.mipmaps,_e=S.isVideoTexture!==!0,Se=ve.__version===void 0||ae===!0,$e=xe.dataReady,et=A(S,se);if(S.isDepthTexture)oe=b(S.format===sr,S.type),Se&&(_e?t.texStorage2D(n.TEXTURE_2D,1,oe,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,oe,se.width,se.height,0,me,U,null));else if(S.isDataTexture)if(Te.length>0){_e&&Se&&t.texStorage2D(n.TEXTURE_2D,et,oe,Te[0].width,Te[0].height);for(let ce=0,Be=Te.length;ce<Be;ce++)ie=Te[ce],_e?$e&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,me,U,ie.data):t.texImage2D(n.TEXTURE_2D,ce,oe,ie.width,ie.height,0,me,U,ie.data);S.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(n.TEXTURE_2D,et,oe,se.width,se.height),$e&&nn(S,se,me,U)):t.texImage2D(n.TEXTURE_2D,0,oe,se.width,se.height,0,me,U,se.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,oe,Te[0].width,Te[0].height,se.depth);for(let ce=0,Be=Te.length;ce<Be;ce++)if(ie=Te[ce],S.format!==ki)if(me!==null)if(_e){if($e)if(S.layerUpdates.size>0){let tt=Xp(ie.width,ie.height,S.format,S.type);for(let Re of S.layerUpdates){let ht=ie.data.subarray(Re*tt/ie.data.BYTES_PER_ELEMENT,(Re+1)*tt/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Re,ie.width,ie.height,1,me,ht)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,se.depth,me,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,oe,ie.width,ie.height,se.depth,0,ie.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?$e&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,se.depth,me,U,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,oe,ie.width,ie.height,se.depth,0,me,U,ie.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(n.TEXTURE_2D,et,oe,Te[0].width,Te[0].height);for(let ce=0,Be=Te.length;ce<Be;ce++)ie=Te[ce],S.format!==ki?me!==null?_e?$e&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,me,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,oe,ie.width,ie.height,0,ie.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?$e&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,me,U,ie.data):t.texImage2D(n.TEXTURE_2D,ce,oe,ie.width,ie.height,0,me,U,ie.data)}else if(S.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,oe,se.width,se.height,se.depth),$e)if(S.layerUpdates.size>0){let ce=Xp(se.width,se.height,S.format,S.type);for(let Be of S.layerUpdates){let tt=se.data.subarray(Be*ce/se.data.BYTES_PER_ELEMENT,(Be+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,me,U,tt)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,me,U,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,se.width,se.height,se.depth,0,me,U,se.data);else if(S.isData3DTexture)_e?(Se&&t.texStorage3D(n.TEXTURE_3D,et,oe,se.width,se.height,se.depth),$e&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,me,U,se.data)):t.texImage3D(n.TEXTURE_3D,0,oe,se.width,se.height,se.depth,0,me,U,se.data);else if(S.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(n.TEXTURE_2D,et,oe,se.width,se.height);else{let ce=se.width,Be=se.height;for(let tt=0;tt<et;tt++)t.texImage2D(n.TEXTURE_2D,tt,oe,ce,Be,0,me,U,null),ce>>=1,Be>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),f.add(S),ce.onpaint=Be=>{let tt=Be.changedElements;for(let Re of f)tt.includes(Re.image)&&(Re.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let tt=n.RGBA,Re=n.RGBA,ht=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,tt,Re,ht,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(_e&&Se){let ce=Ye(Te[0]);t.texStorage2D(n.TEXTURE_2D,et,oe,ce.width,ce.height)}for(let ce=0,Be=Te.length;ce<Be;ce++)ie=Te[ce],_e?$e&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,me,U,ie):t.texImage2D(n.TEXTURE_2D,ce,oe,me,U,ie);S.generateMipmaps=!1}else if(_e){if(Se){let ce=Ye(se);t.texStorage2D(n.TEXTURE_2D,et,oe,ce.width,ce.height)}$e&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,U,se)}else t.texImage2D(n.TEXTURE_2D,0,oe,me,U,se);E(S)&&S.mipmapsAutoUpdate===!0&&M(he),ve.__version=xe.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function _n(R,S,$){if(S.image.length!==6)return;let he=ft(R,S),ae=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+$);let xe=i.get(ae);if(ae.version!==xe.__version||he===!0){t.activeTexture(n.TEXTURE0+$);let ve=bt.getPrimaries(bt.workingColorSpace),ne=S.colorSpace===rr?null:bt.getPrimaries(S.colorSpace),se=S.colorSpace===rr||ve===ne?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let me=S.isCompressedTexture||S.image[0].isCompressedTexture,U=S.image[0]&&S.image[0].isDataTexture,oe=[];for(let Re=0;Re<6;Re++)!me&&!U?oe[Re]=y(S.image[Re],!0,s.maxCubemapSize):oe[Re]=U?S.image[Re].image:S.image[Re],oe[Re]=Ge(S,oe[Re]);let ie=oe[0],Te=r.convert(S.format,S.colorSpace),_e=r.convert(S.type),Se=C(S.internalFormat,Te,_e,S.normalized,S.colorSpace),$e=S.isVideoTexture!==!0,et=xe.__version===void 0||he===!0,ce=ae.dataReady,Be=A(S,ie);_t(n.TEXTURE_CUBE_MAP,S);let tt;if(S.isDepthTexture){if(Se=b(S.format===sr,S.type),et)if($e)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ie.width,ie.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,ie.width,ie.height,0,Te,_e,null)}else if(me){$e&&et&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,ie.width,ie.height);for(let Re=0;Re<6;Re++){tt=oe[Re].mipmaps;for(let ht=0;ht<tt.length;ht++){let Zt=tt[ht];S.format!==ki?Te!==null?$e?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ht,0,0,Zt.width,Zt.height,Te,Zt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ht,Se,Zt.width,Zt.height,0,Zt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$e?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ht,0,0,Zt.width,Zt.height,Te,_e,Zt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ht,Se,Zt.width,Zt.height,0,Te,_e,Zt.data)}}}else{if(tt=S.mipmaps,$e&&et){tt.length>0&&Be++;let Re=Ye(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(U){$e?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,oe[Re].width,oe[Re].height,Te,_e,oe[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,oe[Re].width,oe[Re].height,0,Te,_e,oe[Re].data);for(let ht=0;ht<tt.length;ht++){let Qn=tt[ht].image[Re].image;$e?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ht+1,0,0,Qn.width,Qn.height,Te,_e,Qn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ht+1,Se,Qn.width,Qn.height,0,Te,_e,Qn.data)}}else{$e?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Te,_e,oe[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,Te,_e,oe[Re]);for(let ht=0;ht<tt.length;ht++){let Zt=tt[ht];$e?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ht+1,0,0,Te,_e,Zt.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ht+1,Se,Te,_e,Zt.image[Re])}}}E(S)&&S.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),xe.__version=ae.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function zt(R,S,$,he,ae,xe){let ve=r.convert($.format,$.colorSpace),ne=r.convert($.type),se=C($.internalFormat,ve,ne,$.normalized,$.colorSpace),me=i.get(S),U=i.get($);if(U.__renderTarget=S,!me.__hasExternalTextures){let oe=Math.max(1,S.width>>xe),ie=Math.max(1,S.height>>xe);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,xe,se,oe,ie,S.depth,0,ve,ne,null):t.texImage2D(ae,xe,se,oe,ie,0,ve,ne,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,he,ae,U.__webglTexture,0,ut(S)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,he,ae,U.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Fn(R,S,$){if(n.bindRenderbuffer(n.RENDERBUFFER,R),S.depthBuffer){let he=S.depthTexture,ae=he&&he.isDepthTexture?he.type:null,xe=b(S.stencilBuffer,ae),ve=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ut(S),xe,S.width,S.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ut(S),xe,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,xe,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,R)}else{let he=S.textures;for(let ae=0;ae<he.length;ae++){let xe=he[ae],ve=r.convert(xe.format,xe.colorSpace),ne=r.convert(xe.type),se=C(xe.internalFormat,ve,ne,xe.normalized,xe.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ut(S),se,S.width,S.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ut(S),se,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,se,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function At(R,S,$){let he=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(S.depthTexture);ae.__renderTarget=S;let xe=he?S.depthTexture.image[0]:S.depthTexture.image;(!ae.__webglTexture||xe.width!==S.width||xe.height!==S.height)&&(xe.width=S.width,xe.height=S.height,S.depthTexture.needsUpdate=!0),he?Me(S.depthTexture,0):ge(S.depthTexture,0);let ve=ae.__webglTexture,ne=ut(S),se=he?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,me=S.depthTexture.format===sr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===tr)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,se,ve,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,me,se,ve,0);else if(S.depthTexture.format===sr)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,se,ve,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,me,se,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Rn(R){let S=i.get(R),$=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let he=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),he){let ae=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,he.removeEventListener("dispose",ae)};he.addEventListener("dispose",ae),S.__depthDisposeCallback=ae}S.__boundDepthTexture=he}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if($)for(let he=0;he<6;he++)At(S.__webglFramebuffer[he],R,he);else R.texture.mipmaps.length>0?At(S.__webglFramebuffer[0],R,0):At(S.__webglFramebuffer,R,0);else if($){S.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[he]),S.__webglDepthbuffer[he]===void 0)S.__webglDepthbuffer[he]=n.createRenderbuffer(),Fn(S.__webglDepthbuffer[he],R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=S.__webglDepthbuffer[he];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,xe)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),Fn(S.__webglDepthbuffer,R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function ln(R,S,$){let he=i.get(R);S!==void 0&&zt(he.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&Rn(R)}function xn(R){let S=R.texture,$=i.get(R),he=i.get(S);R.addEventListener("dispose",G),H(R);let ae=R.textures,xe=R.isWebGLCubeRenderTarget===!0,ve=ae.length>1;if(ve||(he.__webglTexture===void 0&&(he.__webglTexture=n.createTexture()),he.__version=S.version,o.memory.textures++),xe){$.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0){$.__webglFramebuffer[ne]=[];for(let se=0;se<S.mipmaps.length;se++)$.__webglFramebuffer[ne][se]=n.createFramebuffer()}else $.__webglFramebuffer[ne]=n.createFramebuffer()}else{if(S.mipmaps.length>0){$.__webglFramebuffer=[];for(let ne=0;ne<S.mipmaps.length;ne++)$.__webglFramebuffer[ne]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(ve)for(let ne=0,se=ae.length;ne<se;ne++){let me=i.get(ae[ne]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&we(R)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ne=0;ne<ae.length;ne++){let se=ae[ne];$.__webglColorRenderbuffer[ne]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[ne]);let me=r.convert(se.format,se.colorSpace),U=r.convert(se.type),oe=C(se.internalFormat,me,U,se.normalized,se.colorSpace,R.isXRRenderTarget===!0),ie=ut(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,oe,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ne,n.RENDERBUFFER,$.__webglColorRenderbuffer[ne])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),Fn($.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,he.__webglTexture),_t(n.TEXTURE_CUBE_MAP,S);for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)zt($.__webglFramebuffer[ne][se],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else zt($.__webglFramebuffer[ne],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);E(S)?M(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ne=0,se=ae.length;ne<se;ne++){let me=ae[ne],U=i.get(me),oe=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(oe=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,U.__webglTexture),_t(oe,me),zt($.__webglFramebuffer,R,me,n.COLOR_ATTACHMENT0+ne,oe,0),E(me)&&M(oe)}t.unbindTexture()}else{let ne=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ne=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ne,he.__webglTexture),_t(ne,S),S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)zt($.__webglFramebuffer[se],R,S,n.COLOR_ATTACHMENT0,ne,se);else zt($.__webglFramebuffer,R,S,n.COLOR_ATTACHMENT0,ne,0);E(S)?M(ne):S.mipmaps.length>0&&n.texParameteri(ne,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Rn(R)}function k(R){let S=R.textures;for(let $=0,he=S.length;$<he;$++){let ae=S[$];if(E(ae)&&ae.mipmapsAutoUpdate===!0){let xe=I(R),ve=i.get(ae).__webglTexture;t.bindTexture(xe,ve),M(xe),t.unbindTexture()}}}let Pe=[];function Je(R){if(R.samples>0){if(we(R)===!1){let S=R.textures,$=R.width,he=R.height,ae=n.COLOR_BUFFER_BIT,xe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(R),ne=S.length>1;if(ne)for(let me=0;me<S.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let me=0;me<S.length;me++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),ne){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let U=i.get(S[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,U,0)}n.blitFramebuffer(0,0,$,he,0,0,$,he,ae,n.NEAREST),l===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+me),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Pe.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ne)for(let me=0;me<S.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let U=i.get(S[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,U,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function ut(R){return Math.min(s.maxSamples,R.samples)}function we(R){let S=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Wt(R){let S=o.render.frame;u.get(R)!==S&&(u.set(R,S),R.update())}function Ge(R,S){let $=R.colorSpace,he=R.format,ae=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||$!==Zr&&$!==rr&&(bt.getTransfer($)===Ft?(he!==ki||ae!==Fi)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):st("WebGLTextures: Unsupported texture color space:",$)),S}function Ye(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=Q,this.getTextureUnits=re,this.setTextureUnits=fe,this.setTexture2D=ge,this.setTexture2DArray=ye,this.setTexture3D=Ce,this.setTextureCube=Me,this.rebindTextures=ln,this.setupRenderTarget=xn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=Rn,this.setupFrameBufferTexture=zt,this.useMultisampledRTT=we,this.dispose=W}function NR(n,e){function t(i,s=rr){let r,o=bt.getTransfer(s);if(i===Fi)return n.UNSIGNED_BYTE;if(i===Ju)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Zu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Dp)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Np)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Ip)return n.BYTE;if(i===Lp)return n.SHORT;if(i===pa)return n.UNSIGNED_SHORT;if(i===Yu)return n.INT;if(i===fs)return n.UNSIGNED_INT;if(i===Ui)return n.FLOAT;if(i===ps)return n.HALF_FLOAT;if(i===Fp)return n.ALPHA;if(i===Up)return n.RGB;if(i===ki)return n.RGBA;if(i===tr)return n.DEPTH_COMPONENT;if(i===sr)return n.DEPTH_STENCIL;if(i===kp)return n.RED;if(i===Ku)return n.RED_INTEGER;if(i===Dr)return n.RG;if(i===ju)return n.RG_INTEGER;if(i===Qu)return n.RGBA_INTEGER;if(i===Sl||i===Ml||i===wl||i===Tl)if(o===Ft)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Sl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ml)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===wl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Tl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Sl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ml)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===wl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Tl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===eh||i===th||i===nh||i===ih)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===eh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===th)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===nh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ih)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===sh||i===rh||i===oh||i===ah||i===lh||i===Al||i===ch)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===sh||i===rh)return o===Ft?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===oh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ah)return r.COMPRESSED_R11_EAC;if(i===lh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Al)return r.COMPRESSED_RG11_EAC;if(i===ch)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===uh||i===hh||i===dh||i===fh||i===ph||i===mh||i===gh||i===_h||i===xh||i===yh||i===vh||i===bh||i===Sh||i===Mh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===uh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===hh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===dh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===fh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ph)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===mh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===gh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===_h)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===xh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===yh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===vh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===bh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Sh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Mh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===wh||i===Th||i===Ah)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===wh)return o===Ft?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Th)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ah)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Eh||i===Ch||i===El||i===Rh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Eh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Ch)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===El)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Rh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ro?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var FR=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,UR=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,tm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new gl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Ns({vertexShader:FR,fragmentShader:UR,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Xn(new _l(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},nm=class extends Ls{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,d=null,p=null,m=null,v=typeof XRWebGLBinding<"u",_=new tm,g={},y=t.getContextAttributes(),E=null,M=null,I=[],C=[],b=new Et,A=null,H=null,F=new Ii;F.viewport=new an;let D=new Ii;D.viewport=new an;let G=[F,D],V=new Wu,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ge=I[ee];return ge===void 0&&(ge=new ra,I[ee]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(ee){let ge=I[ee];return ge===void 0&&(ge=new ra,I[ee]=ge),ge.getGripSpace()},this.getHand=function(ee){let ge=I[ee];return ge===void 0&&(ge=new ra,I[ee]=ge),ge.getHandSpace()};function Z(ee){let ge=C.indexOf(ee.inputSource);if(ge===-1)return;let ye=I[ge];ye!==void 0&&(ye.update(ee.inputSource,ee.frame,c||o),ye.dispatchEvent({type:ee.type,data:ee.inputSource}))}function z(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",ue);for(let ee=0;ee<I.length;ee++){let ge=C[ee];ge!==null&&(C[ee]=null,I[ee].disconnect(ge))}N=null,W=null,_.reset();for(let ee in g)delete g[ee];if(e.setRenderTarget(E),p=null,d=null,f=null,s=null,M=null,de.stop(),i.isPresenting=!1,e.setPixelRatio(A),e.setSize(b.width,b.height,!1),H!==null){let ee=H.camera;ee.fov=H.fov,ee.zoom=H.zoom,ee.updateProjectionMatrix(),H=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:p},this.getBinding=function(){return f===null&&v&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",z),s.addEventListener("inputsourceschange",ue),y.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(b),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ye=null,Ce=null,Me=null;y.depth&&(Me=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ye=y.stencil?sr:tr,Ce=y.stencil?ro:fs);let Xe={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};f=this.getBinding(),d=f.createProjectionLayer(Xe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new Li(d.textureWidth,d.textureHeight,{format:ki,type:Fi,depthTexture:new nr(d.textureWidth,d.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,ye),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ye={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,ye),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),M=new Li(p.framebufferWidth,p.framebufferHeight,{format:ki,type:Fi,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),de.setContext(s),de.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return _.getDepthTexture()};function ue(ee){for(let ge=0;ge<ee.removed.length;ge++){let ye=ee.removed[ge],Ce=C.indexOf(ye);Ce>=0&&(C[Ce]=null,I[Ce].disconnect(ye))}for(let ge=0;ge<ee.added.length;ge++){let ye=ee.added[ge],Ce=C.indexOf(ye);if(Ce===-1){for(let Xe=0;Xe<I.length;Xe++)if(Xe>=C.length){C.push(ye),Ce=Xe;break}else if(C[Xe]===null){C[Xe]=ye,Ce=Xe;break}if(Ce===-1)break}let Me=I[Ce];Me&&Me.connect(ye)}}function K(ee,ge){ge===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ge.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ge=ee.near,ye=ee.far;_.texture!==null&&(_.depthNear>0&&(ge=_.depthNear),_.depthFar>0&&(ye=_.depthFar)),V.near=D.near=F.near=ge,V.far=D.far=F.far=ye,(N!==V.near||W!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),N=V.near,W=V.far),V.layers.mask=ee.layers.mask|6,F.layers.mask=V.layers.mask&-5,D.layers.mask=V.layers.mask&-3;let Ce=ee.parent,Me=V.cameras;K(V,Ce);for(let Xe=0;Xe<Me.length;Xe++)K(Me[Xe],Ce);V.projectionMatrix.copy(F.projectionMatrix),V.projectionMatrixInverse.copy(F.projectionMatrixInverse),H===null&&ee.isPerspectiveCamera&&(H={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,V,Ce)};function Q(ee,ge,ye){ye===null?ee.matrix.copy(ge.matrixWorld):(ee.matrix.copy(ye.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ge.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ge.projectionMatrix),ee.projectionMatrixInverse.copy(ge.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=vu*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&p===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ee)},this.hasDepthSensing=function(){return _.texture!==null},this.getDepthSensingMesh=function(){return _.getMesh(V)},this.getCameraTexture=function(ee){return g[ee]};let re=null;function fe(ee,ge){if(u=ge.getViewerPose(c||o),m=ge,u!==null){let ye=u.views;p!==null&&(e.setRenderTargetFramebuffer(M,p.framebuffer),e.setRenderTarget(M));let Ce=!1;ye.length!==V.cameras.length&&(V.cameras.length=0,Ce=!0);for(let We=0;We<ye.length;We++){let _t=ye[We],ft=null;if(p!==null)ft=p.getViewport(_t);else{let nn=f.getViewSubImage(d,_t);ft=nn.viewport,We===0&&(e.setRenderTargetTextures(M,nn.colorTexture,nn.depthStencilTexture),e.setRenderTarget(M))}let ot=G[We];ot===void 0&&(ot=new Ii,ot.layers.enable(We),ot.viewport=new an,G[We]=ot),ot.matrix.fromArray(_t.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(_t.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(ft.x,ft.y,ft.width,ft.height),We===0&&(V.matrix.copy(ot.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ce===!0&&V.cameras.push(ot)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){f=i.getBinding();let We=f.getDepthInformation(ye[0]);We&&We.isValid&&We.texture&&_.init(We,s.renderState)}if(Me&&Me.includes("camera-access")&&v){e.state.unbindTexture(),f=i.getBinding();for(let We=0;We<ye.length;We++){let _t=ye[We].camera;if(_t){let ft=g[_t];ft||(ft=new gl,g[_t]=ft);let ot=f.getCameraImage(_t);ft.sourceTexture=ot}}}}for(let ye=0;ye<I.length;ye++){let Ce=C[ye],Me=I[ye];Ce!==null&&Me!==void 0&&Me.update(Ce,ge,c||o)}re&&re(ee,ge),ge.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ge}),m=null}let de=new Ny;de.setAnimationLoop(fe),this.setAnimationLoop=function(ee){re=ee},this.dispose=function(){}}},kR=new Jt,Wy=new rt;Wy.set(-1,0,0,0,1,0,0,0,1);function OR(n,e){function t(_,g){_.matrixAutoUpdate===!0&&_.updateMatrix(),g.value.copy(_.matrix)}function i(_,g){g.color.getRGB(_.fogColor.value,Hp(n)),g.isFog?(_.fogNear.value=g.near,_.fogFar.value=g.far):g.isFogExp2&&(_.fogDensity.value=g.density)}function s(_,g,y,E,M){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(_,g):g.isMeshLambertMaterial?(r(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(_,g),f(_,g)):g.isMeshPhongMaterial?(r(_,g),u(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(_,g),d(_,g),g.isMeshPhysicalMaterial&&p(_,g,M)):g.isMeshMatcapMaterial?(r(_,g),m(_,g)):g.isMeshDepthMaterial?r(_,g):g.isMeshDistanceMaterial?(r(_,g),v(_,g)):g.isMeshNormalMaterial?r(_,g):g.isLineBasicMaterial?(o(_,g),g.isLineDashedMaterial&&a(_,g)):g.isPointsMaterial?l(_,g,y,E):g.isSpriteMaterial?c(_,g):g.isShadowMaterial?(_.color.value.copy(g.color),_.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(_,g){_.opacity.value=g.opacity,g.color&&_.diffuse.value.copy(g.color),g.emissive&&_.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.bumpMap&&(_.bumpMap.value=g.bumpMap,t(g.bumpMap,_.bumpMapTransform),_.bumpScale.value=g.bumpScale,g.side===ui&&(_.bumpScale.value*=-1)),g.normalMap&&(_.normalMap.value=g.normalMap,t(g.normalMap,_.normalMapTransform),_.normalScale.value.copy(g.normalScale),g.side===ui&&_.normalScale.value.negate()),g.displacementMap&&(_.displacementMap.value=g.displacementMap,t(g.displacementMap,_.displacementMapTransform),_.displacementScale.value=g.displacementScale,_.displacementBias.value=g.displacementBias),g.emissiveMap&&(_.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,_.emissiveMapTransform)),g.specularMap&&(_.specularMap.value=g.specularMap,t(g.specularMap,_.specularMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest);let y=e.get(g),E=y.envMap,M=y.envMapRotation;E&&(_.envMap.value=E,_.envMapRotation.value.setFromMatrix4(kR.makeRotationFromEuler(M)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&_.envMapRotation.value.premultiply(Wy),_.reflectivity.value=g.reflectivity,_.ior.value=g.ior,_.refractionRatio.value=g.refractionRatio),g.lightMap&&(_.lightMap.value=g.lightMap,_.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,_.lightMapTransform)),g.aoMap&&(_.aoMap.value=g.aoMap,_.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,_.aoMapTransform))}function o(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform))}function a(_,g){_.dashSize.value=g.dashSize,_.totalSize.value=g.dashSize+g.gapSize,_.scale.value=g.scale}function l(_,g,y,E){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.size.value=g.size*y,_.scale.value=E*.5,g.map&&(_.map.value=g.map,t(g.map,_.uvTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function c(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.rotation.value=g.rotation,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function u(_,g){_.specular.value.copy(g.specular),_.shininess.value=Math.max(g.shininess,1e-4)}function f(_,g){g.gradientMap&&(_.gradientMap.value=g.gradientMap)}function d(_,g){_.metalness.value=g.metalness,g.metalnessMap&&(_.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,_.metalnessMapTransform)),_.roughness.value=g.roughness,g.roughnessMap&&(_.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,_.roughnessMapTransform)),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)}function p(_,g,y){_.ior.value=g.ior,g.diffuseRoughness>0&&(_.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(_.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,_.diffuseRoughnessMapTransform))),g.sheen>0&&(_.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),_.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(_.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,_.sheenColorMapTransform)),g.sheenRoughnessMap&&(_.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,_.sheenRoughnessMapTransform))),g.clearcoat>0&&(_.clearcoat.value=g.clearcoat,_.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(_.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,_.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(_.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,_.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(_.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,_.clearcoatNormalMapTransform),_.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ui&&_.clearcoatNormalScale.value.negate())),g.dispersion>0&&(_.dispersion.value=g.dispersion),g.retroreflectivity>0&&(_.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(_.iridescence.value=g.iridescence,_.iridescenceIOR.value=g.iridescenceIOR,_.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,_.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(_.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,_.iridescenceMapTransform)),g.iridescenceThicknessMap&&(_.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,_.iridescenceThicknessMapTransform))),g.transmission>0&&(_.transmission.value=g.transmission,_.transmissionSamplerMap.value=y.texture,_.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(_.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,_.transmissionMapTransform)),_.thickness.value=g.thickness,g.thicknessMap&&(_.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,_.thicknessMapTransform)),_.attenuationDistance.value=g.attenuationDistance,_.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(_.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(_.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,_.anisotropyMapTransform))),_.specularIntensity.value=g.specularIntensity,_.specularColor.value.copy(g.specularColor),g.specularColorMap&&(_.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,_.specularColorMapTransform)),g.specularIntensityMap&&(_.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,_.specularIntensityMapTransform))}function m(_,g){g.matcap&&(_.matcap.value=g.matcap)}function v(_,g){let y=e.get(g).light;_.referencePosition.value.setFromMatrixPosition(y.matrixWorld),_.nearDistance.value=y.shadow.camera.near,_.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function BR(n,e,t,i){let s={},r={};function o(y,E){let M=E.program;i.uniformBlockBinding(y,M,s[y.id])}function a(y,E){let M=s[y.id];M===void 0&&(m(y),M=l(y),s[y.id]=M,y.addEventListener("dispose",_));let I=E.program;i.updateUBOMapping(y,I);let C=e.render.frame;r[y.id]!==C&&(c(y),r[y.id]=C)}function l(y){let E=n.createBuffer(),M=y.__size,I=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,M,I),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(y){let E=s[y.id],M=y.uniforms,I=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let C=0,b=M.length;C<b;C++){let A=M[C];if(Array.isArray(A))for(let H=0,F=A.length;H<F;H++)u(A[H],C,H,I);else u(A,C,0,I)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,E,M,I){if(d(y,E,M,I)===!0){let C=y.__offset,b=y.value;if(Array.isArray(b)){let A=0;for(let H=0;H<b.length;H++){let F=b[H],D=v(F,!0);f(F,y.__data,A),A+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(b,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,y.__data)}}function f(y,E,M){typeof y=="number"||typeof y=="boolean"?E[M]=y:y.isMatrix3?(E[M]=y.elements[0],E[M+1]=y.elements[1],E[M+2]=y.elements[2],E[M+3]=0,E[M+4]=y.elements[3],E[M+5]=y.elements[4],E[M+6]=y.elements[5],E[M+7]=0,E[M+8]=y.elements[6],E[M+9]=y.elements[7],E[M+10]=y.elements[8],E[M+11]=0):ArrayBuffer.isView(y)?E.set(y.subarray(0,E.length-M),M):y.toArray(E,M)}function d(y,E,M,I){let C=y.value,b=E+"_"+M;if(Array.isArray(C)){I[b]===void 0&&(I[b]=[]);let A=I[b],H=!1;for(let F=0;F<C.length;F++)p(C[F],A,F)===!0&&(H=!0);return H}return p(C,I,b)}function p(y,E,M){if(E[M]===void 0)return typeof y=="number"||typeof y=="boolean"?E[M]=y:ArrayBuffer.isView(y)?E[M]=y.slice():E[M]=y.clone(),!0;{let I=E[M];if(typeof y=="number"||typeof y=="boolean"){if(I!==y)return E[M]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(I.equals(y)===!1)return I.copy(y),!0}}return!1}function m(y){let E=y.uniforms,M=0,I=16;for(let b=0,A=E.length;b<A;b++){let H=Array.isArray(E[b])?E[b]:[E[b]];for(let F=0,D=H.length;F<D;F++){let G=H[F],V=Array.isArray(G.value)?G.value:[G.value],N=Array.isArray(E[b])||Array.isArray(G.value),W=M;for(let z=0,ue=V.length;z<ue;z++){let K=V[z],Q=v(K,N),re=M%I,fe=re%Q.boundary,de=re+fe;M+=fe,de!==0&&I-de<Q.storage&&(M+=I-de),z===0&&(W=M),M+=Q.storage}let Z=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new Z((M-W)/Float32Array.BYTES_PER_ELEMENT),G.__offset=W}}let C=M%I;return C>0&&(M+=I-C),y.__size=M,y.__cache={},this}function v(y,E){let M={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(M.boundary=4,M.storage=4):y.isVector2?(M.boundary=8,M.storage=8):y.isVector3||y.isColor?(M.boundary=16,M.storage=12):y.isVector4?(M.boundary=16,M.storage=16):y.isMatrix3?(M.boundary=16,M.storage=48):y.isMatrix4?(M.boundary=16,M.storage=64):y.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(M.boundary=16,M.storage=y.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",y),E===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function _(y){let E=y.target;E.removeEventListener("dispose",_),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function g(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var VR=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Us=null;function zR(){return Us===null&&(Us=new oa(VR,16,16,Dr,ps),Us.name="DFG_LUT",Us.minFilter=ci,Us.magFilter=ci,Us.wrapS=Is,Us.wrapT=Is,Us.generateMipmaps=!1,Us.needsUpdate=!0),Us}var Nh=class{constructor(e={}){let{canvas:t=ny(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1,outputBufferType:p=Fi}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let v=p,_=new Set([Qu,ju,Ku]),g=new Set([Fi,fs,pa,ro,Ju,Zu]),y=new Uint32Array(4),E=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},I=null,C=null,b=[],A=[],H=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,D=!1,G=null,V=null,N=null,W=null;this._outputColorSpace=Ri;let Z=0,z=0,ue=null,K=-1,Q=null,re=new an,fe=new an,de=null,ee=new Ct(0),ge=0,ye=t.width,Ce=t.height,Me=1,Xe=null,ct=null,We=new an(0,0,ye,Ce),_t=new an(0,0,ye,Ce),ft=!1,ot=new Qr,nn=new Au,qt=!1,_n=!1,zt=new Jt,Fn=new X,At=new an,Rn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ln=!1;function xn(){return ue===null?Me:1}let k=i;function Pe(T,O){return t.getContext(T,O)}let Je,ut,we,Wt,Ge,Ye,R,S,$,he,ae,xe,ve,ne,se,me,U,oe,ie,Te,_e,Se,$e;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Re,!1),k===null){let O="webgl2";if(k=Pe(O,T),k===null)throw Pe(O)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(T){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),st("WebGLRenderer: "+T.message),T}function et(){Je=new jE(k),Je.init(),_e=new NR(k,Je),ut=new zE(k,Je,e,_e),we=new LR(k,Je),ut.reversedDepthBuffer&&d&&we.buffers.depth.setReversed(!0),V=k.createFramebuffer(),N=k.createFramebuffer(),W=k.createFramebuffer(),Wt=new tC(k),Ge=new xR,Ye=new DR(k,Je,we,Ge,ut,_e,Wt),R=new KE(F),S=new iT(k),Se=new BE(k,S),$=new QE(k,S,Wt,Se),he=new iC(k,$,S,Se,Wt),oe=new nC(k,ut,Ye),se=new GE(Ge),ae=new _R(F,R,Je,ut,Se,se),xe=new OR(F,Ge),ve=new vR,ne=new AR(Je),U=new OE(F,R,we,he,m,l),me=new IR(F,he,ut),$e=new BR(k,Wt,ut,we),ie=new VE(k,Je,Wt),Te=new eC(k,Je,Wt),Wt.programs=ae.programs,F.capabilities=ut,F.extensions=Je,F.properties=Ge,F.renderLists=ve,F.shadowMap=me,F.state=we,F.info=Wt}v!==Fi&&(H=new rC(v,t.width,t.height,a,s,r));let ce=new nm(F,k);this.xr=ce,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let T=Je.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Je.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(T){T!==void 0&&(Me=T,this.setSize(ye,Ce,!1))},this.getSize=function(T){return T.set(ye,Ce)},this.setSize=function(T,O,j=!0){if(ce.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}ye=T,Ce=O,t.width=Math.floor(T*Me),t.height=Math.floor(O*Me),j===!0&&(t.style.width=T+"px",t.style.height=O+"px"),H!==null&&H.setSize(t.width,t.height),this.setViewport(0,0,T,O)},this.getDrawingBufferSize=function(T){return T.set(ye*Me,Ce*Me).floor()},this.setDrawingBufferSize=function(T,O,j){ye=T,Ce=O,Me=j,t.width=Math.floor(T*j),t.height=Math.floor(O*j),this.setViewport(0,0,T,O)},this.setEffects=function(T){if(v===Fi){st("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let O=0;O<T.length;O++)if(T[O].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}H.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(re)},this.getViewport=function(T){return T.copy(We)},this.setViewport=function(T,O,j,q){T.isVector4?We.set(T.x,T.y,T.z,T.w):We.set(T,O,j,q),we.viewport(re.copy(We).multiplyScalar(xn()).round())},this.getScissor=function(T){return T.copy(_t)},this.setScissor=function(T,O,j,q){T.isVector4?_t.set(T.x,T.y,T.z,T.w):_t.set(T,O,j,q),we.scissor(fe.copy(_t).multiplyScalar(xn()).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(T){we.setScissorTest(ft=T)},this.setOpaqueSort=function(T){Xe=T},this.setTransparentSort=function(T){ct=T},this.getClearColor=function(T){return T.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(T=!0,O=!0,j=!0){let q=0;if(T){let Y=!1;if(ue!==null){let Ae=ue.texture.format;Y=_.has(Ae)}if(Y){let Ae=ue.texture.type,Ie=g.has(Ae),Ee=U.getClearColor(),Le=U.getClearAlpha(),ze=Ee.r,it=Ee.g,yt=Ee.b;Ie?(y[0]=ze,y[1]=it,y[2]=yt,y[3]=Le,k.clearBufferuiv(k.COLOR,0,y)):(E[0]=ze,E[1]=it,E[2]=yt,E[3]=Le,k.clearBufferiv(k.COLOR,0,E))}else q|=k.COLOR_BUFFER_BIT}O&&(q|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(q|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&k.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),G=T},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),U.dispose(),ve.dispose(),ne.dispose(),Ye.dispose(),Ge.dispose(),R.dispose(),he.dispose(),$.dispose(),Se.dispose(),$e.dispose(),ae.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Gl),ce.removeEventListener("sessionend",_s),Bs.stop()};function Be(T){T.preventDefault(),ol("WebGLRenderer: Context Lost."),D=!0}function tt(){ol("WebGLRenderer: Context Restored."),D=!1;let T=Wt.autoReset,O=me.enabled,j=me.autoUpdate,q=me.needsUpdate,Y=me.type;et(),Wt.autoReset=T,me.enabled=O,me.autoUpdate=j,me.needsUpdate=q,me.type=Y}function Re(T){st("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ht(T){let O=T.target;O.removeEventListener("dispose",ht),Zt(O)}function Zt(T){Qn(T),Ge.remove(T)}function Qn(T){let O=Ge.get(T).programs;O!==void 0&&(O.forEach(function(j){ae.releaseProgram(j)}),T.isShaderMaterial&&ae.releaseShaderCache(T))}this.renderBufferDirect=function(T,O,j,q,Y,Ae){O===null&&(O=Rn);let Ie=Y.isMesh&&Y.matrixWorld.determinantAffine()<0,Ee=Ta(T,O,j,q,Y);we.setMaterial(q,Ie);let Le=j.index,ze=1;if(q.wireframe===!0){if(Le=$.getWireframeAttribute(j),Le===void 0)return;ze=2}let it=j.drawRange,yt=j.attributes.position,Ve=it.start*ze,vt=(it.start+it.count)*ze;Ae!==null&&(Ve=Math.max(Ve,Ae.start*ze),vt=Math.min(vt,(Ae.start+Ae.count)*ze)),Le!==null?(Ve=Math.max(Ve,0),vt=Math.min(vt,Le.count)):yt!=null&&(Ve=Math.max(Ve,0),vt=Math.min(vt,yt.count));let rn=vt-Ve;if(rn<0||rn===1/0)return;Se.setup(Y,q,Ee,j,Le);let Ut,kt=ie;if(Le!==null&&(Ut=S.get(Le),kt=Te,kt.setIndex(Ut)),Y.isMesh)q.wireframe===!0?(we.setLineWidth(q.wireframeLinewidth*xn()),kt.setMode(k.LINES)):kt.setMode(k.TRIANGLES);else if(Y.isLine){let Pn=q.linewidth;Pn===void 0&&(Pn=1),we.setLineWidth(Pn*xn()),Y.isLineSegments?kt.setMode(k.LINES):Y.isLineLoop?kt.setMode(k.LINE_LOOP):kt.setMode(k.LINE_STRIP)}else Y.isPoints?kt.setMode(k.POINTS):Y.isSprite&&kt.setMode(k.TRIANGLES);if(Y.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))kt.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{let Pn=Y._multiDrawStarts,ke=Y._multiDrawCounts,yn=Y._multiDrawCount,Mt=Le?S.get(Le).bytesPerElement:1,zs=Ge.get(q).currentProgram.getUniforms();for(let vn=0;vn<yn;vn++)zs.setValue(k,"_gl_DrawID",vn),kt.render(Pn[vn]/Mt,ke[vn])}else if(Y.isInstancedMesh)kt.renderInstances(Ve,rn,Y.count);else if(j.isInstancedBufferGeometry){let Pn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,ke=Math.min(j.instanceCount,Pn);kt.renderInstances(Ve,rn,ke)}else kt.render(Ve,rn)};function Sa(T,O,j,q){G!==null&&T.isNodeMaterial&&G.setObject(q,T),qt===!0&&se.setState(T,j,!1),T.transparent===!0&&T.side===ji&&T.forceSinglePass===!1?(T.side=ui,T.needsUpdate=!0,xs(T,O,q),T.side=Lr,T.needsUpdate=!0,xs(T,O,q),T.side=ji):xs(T,O,q)}this.compile=function(T,O,j=null){j===null&&(j=T),G!==null&&G.renderStart(T,O,j),C=ne.get(j),C.init(O),A.push(C),j.traverseVisible(function(Y){Y.isLight&&Y.layers.test(O.layers)&&(C.pushLight(Y),Y.castShadow&&C.pushShadow(Y))}),T!==j&&T.traverseVisible(function(Y){Y.isLight&&Y.layers.test(O.layers)&&(C.pushLight(Y),Y.castShadow&&C.pushShadow(Y))}),C.setupLights(),G!==null&&G.updateLights(C.state.lightsArray),_n=this.localClippingEnabled,qt=se.init(this.clippingPlanes,_n),qt===!0&&se.setGlobalState(this.clippingPlanes,O),G!==null&&me.render(C.state.shadowsArray,j,O);let q=new Set;return T.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let Ae=Y.material;if(Ae)if(Array.isArray(Ae))for(let Ie=0;Ie<Ae.length;Ie++){let Ee=Ae[Ie];Sa(Ee,j,O,Y),q.add(Ee)}else Sa(Ae,j,O,Y),q.add(Ae)}),C=A.pop(),G!==null&&G.renderEnd(),q},this.compileAsync=function(T,O,j=null){let q=this.compile(T,O,j);return new Promise(Y=>{function Ae(){if(q.forEach(function(Ie){let Le=Ge.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&q.delete(Ie)}),q.size===0){Y(T);return}setTimeout(Ae,10)}Je.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let co=null;function Td(T){co&&co(T)}function Gl(){Bs.stop()}function _s(){Bs.start()}let Bs=new Ny;Bs.setAnimationLoop(Td),typeof self<"u"&&Bs.setContext(self),this.setAnimationLoop=function(T){co=T,ce.setAnimationLoop(T),T===null?Bs.stop():Bs.start()},ce.addEventListener("sessionstart",Gl),ce.addEventListener("sessionend",_s),this.render=function(T,O){if(O!==void 0&&O.isCamera!==!0){st("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;G!==null&&G.renderStart(T,O);let j=ce.enabled===!0&&ce.isPresenting===!0,q=H!==null&&(ue===null||j)&&H.begin(F,ue);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(H===null||H.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(O),O=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(F,T,O,ue),C=ne.get(T,A.length),C.init(O),C.state.textureUnits=Ye.getTextureUnits(),A.push(C),zt.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),O.isArrayCamera?nn.setFromArrayCamera(O):ot.setFromProjectionMatrix(zt,Zi,O.reversedDepth),_n=this.localClippingEnabled,qt=se.init(this.clippingPlanes,_n),I=ve.get(T,b.length),I.init(),b.push(I),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Ie=F.xr.getDepthSensingMesh();Ie!==null&&Vs(Ie,O,-1/0,F.sortObjects)}Vs(T,O,0,F.sortObjects),I.finish(),G!==null&&G.updateLights(C.state.lightsArray),F.sortObjects===!0&&I.sort(Xe,ct),ln=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,ln&&U.addToRenderList(I,T),this.info.autoReset===!0&&this.info.reset(),qt===!0&&se.beginShadows();let Y=C.state.shadowsArray;if(me.render(Y,T,O),qt===!0&&se.endShadows(),(q&&H.hasRenderPass())===!1){let Ie=I.opaque,Ee=I.transmissive;if(C.setupLights(),O.isArrayCamera){let Le=O.cameras;if(Ee.length>0)for(let ze=0,it=Le.length;ze<it;ze++){let yt=Le[ze];Qi(Ie,Ee,T,yt)}ln&&U.render(T);for(let ze=0,it=Le.length;ze<it;ze++){let yt=Le[ze];Ma(I,T,yt,yt.viewport)}}else Ee.length>0&&Qi(Ie,Ee,T,O),ln&&U.render(T),Ma(I,T,O)}ue!==null&&z===0&&(Ye.updateMultisampleRenderTarget(ue),Ye.updateRenderTargetMipmap(ue)),q&&H.end(F),T.isScene===!0&&T.onAfterRender(F,T,O),Se.resetDefaultState(),K=-1,Q=null,A.pop(),A.length>0?(C=A[A.length-1],Ye.setTextureUnits(C.state.textureUnits),qt===!0&&se.setGlobalState(F.clippingPlanes,C.state.camera)):C=null,b.pop(),b.length>0?I=b[b.length-1]:I=null,G!==null&&G.renderEnd()};function Vs(T,O,j,q){if(T.visible===!1)return;if(T.layers.test(O.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(O);else if(T.isLight)C.pushLight(T),T.castShadow&&C.pushShadow(T);else if(T.isSprite){let Ie=O.isArrayCamera?nn:ot;if(!T.frustumCulled||T.intersectsFrustum(Ie)){q&&At.setFromMatrixPosition(T.matrixWorld).applyMatrix4(zt);let Ee=he.update(T),Le=T.material;Le.visible&&I.push(T,Ee,Le,j,At.z,null,O)}}else if(T.isMesh||T.isLine||T.isPoints){let Ie=O.isArrayCamera?nn:ot;if(!T.frustumCulled||T.intersectsFrustum(Ie)){let Ee=he.update(T),Le=T.material;if(q&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),At.copy(T.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),At.copy(Ee.boundingSphere.center)),At.applyMatrix4(T.matrixWorld).applyMatrix4(zt)),Array.isArray(Le)){let ze=Ee.groups;for(let it=0,yt=ze.length;it<yt;it++){let Ve=ze[it],vt=Le[Ve.materialIndex];vt&&vt.visible&&I.push(T,Ee,vt,j,At.z,Ve,O)}}else Le.visible&&I.push(T,Ee,Le,j,At.z,null,O)}}}let Ae=T.children;for(let Ie=0,Ee=Ae.length;Ie<Ee;Ie++)Vs(Ae[Ie],O,j,q)}function Ma(T,O,j,q){let{opaque:Y,transmissive:Ae,transparent:Ie}=T;C.setupLightsView(j),qt===!0&&se.setGlobalState(F.clippingPlanes,j),q&&we.viewport(re.copy(q)),Y.length>0&&cn(Y,O,j),Ae.length>0&&cn(Ae,O,j),Ie.length>0&&cn(Ie,O,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Qi(T,O,j,q){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[q.id]===void 0){let Ve=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[q.id]=new Li(1,1,{generateMipmaps:!0,type:Ve?ps:Fi,minFilter:ir,samples:Math.max(4,ut.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:bt.workingColorSpace})}let Ae=C.state.transmissionRenderTarget[q.id],Ie=q.viewport||re;Ae.setSize(Ie.z*F.transmissionResolutionScale,Ie.w*F.transmissionResolutionScale);let Ee=F.getRenderTarget(),Le=F.getActiveCubeFace(),ze=F.getActiveMipmapLevel();F.setRenderTarget(Ae),F.getClearColor(ee),ge=F.getClearAlpha(),ge<1&&F.setClearColor(16777215,.5),F.clear(),ln&&U.render(j);let it=F.toneMapping;F.toneMapping=Fs;let yt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),C.setupLightsView(q),qt===!0&&se.setGlobalState(F.clippingPlanes,q),cn(T,j,q),Ye.updateMultisampleRenderTarget(Ae),Ye.updateRenderTargetMipmap(Ae),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let vt=0,rn=O.length;vt<rn;vt++){let Ut=O[vt],{object:kt,geometry:Pn,material:ke,group:yn}=Ut;if(ke.side===ji&&kt.layers.test(q.layers)){let Mt=ke.side;ke.side=ui,ke.needsUpdate=!0,pn(kt,j,q,Pn,ke,yn),ke.side=Mt,ke.needsUpdate=!0,Ve=!0}}Ve===!0&&(Ye.updateMultisampleRenderTarget(Ae),Ye.updateRenderTargetMipmap(Ae))}F.setRenderTarget(Ee,Le,ze),F.setClearColor(ee,ge),yt!==void 0&&(q.viewport=yt),F.toneMapping=it}function cn(T,O,j){let q=O.isScene===!0?O.overrideMaterial:null;for(let Y=0,Ae=T.length;Y<Ae;Y++){let Ie=T[Y],{object:Ee,geometry:Le,group:ze}=Ie,it=Ie.material;it.allowOverride===!0&&q!==null&&(it=q),Ee.layers.test(j.layers)&&pn(Ee,O,j,Le,it,ze)}}function pn(T,O,j,q,Y,Ae){G!==null&&Y.isNodeMaterial&&G.setObject(T,Y),T.onBeforeRender(F,O,j,q,Y,Ae),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),Y.onBeforeRender(F,O,j,q,T,Ae),Y.transparent===!0&&Y.side===ji&&Y.forceSinglePass===!1?(Y.side=ui,Y.needsUpdate=!0,F.renderBufferDirect(j,O,q,Y,T,Ae),Y.side=Lr,Y.needsUpdate=!0,F.renderBufferDirect(j,O,q,Y,T,Ae),Y.side=ji):F.renderBufferDirect(j,O,q,Y,T,Ae),T.onAfterRender(F,O,j,q,Y,Ae)}function mn(T){let O=0;for(let j of T)j.texture!==null&&O++;return O}function xs(T,O,j){O.isScene!==!0&&(O=Rn);let q=Ge.get(T),Y=C.state.lights,Ae=C.state.shadowsArray,Ie=Y.state.version,Ee=ae.getParameters(T,Y.state,Ae,O,j,C.state.lightProbeGridArray),Le=ae.getProgramCacheKey(Ee),ze=q.programs;q.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?O.environment:null,q.fog=O.fog;let it=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;q.envMap=R.get(T.envMap||q.environment,it),q.envMapRotation=q.environment!==null&&T.envMap===null?O.environmentRotation:T.envMapRotation,ze===void 0&&(T.addEventListener("dispose",ht),ze=new Map,q.programs=ze,q.programVariants=new Map);let yt=ze.get(Le);if(yt!==void 0){if(q.currentProgram===yt&&q.lightsStateVersion===Ie)return wa(T,Ee),yt}else Ee.uniforms=ae.getUniforms(T),G!==null&&T.isNodeMaterial&&G.build(T,j,Ee),T.onBeforeCompile(Ee,F),yt=ae.acquireProgram(Ee,Le),ze.set(Le,yt),q.uniforms=Ee.uniforms;let Ve=q.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Ve.clippingPlanes=se.uniform),wa(T,Ee),q.needsLights=cr(T),q.lightsStateVersion=Ie,q.needsLights&&(Ve.ambientLightColor.value=Y.state.ambient,Ve.lightProbe.value=Y.state.probe,Ve.sunLights.value=Y.state.sun,Ve.sunLightShadows.value=Y.state.sunShadow,Ve.directionalLights.value=Y.state.directional,Ve.directionalLightShadows.value=Y.state.directionalShadow,Ve.spotLights.value=Y.state.spot,Ve.spotLightShadows.value=Y.state.spotShadow,Ve.rectAreaLights.value=Y.state.rectArea,Ve.ltc_1.value=Y.state.rectAreaLTC1,Ve.ltc_2.value=Y.state.rectAreaLTC2,Ve.pointLights.value=Y.state.point,Ve.pointLightShadows.value=Y.state.pointShadow,Ve.hemisphereLights.value=Y.state.hemi,Ve.sunShadowMatrix.value=Y.state.sunShadowMatrix,Ve.sunShadowCascade.value=Y.state.sunShadowCascade,Ve.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,Ve.spotLightMatrix.value=Y.state.spotLightMatrix,Ve.spotLightMap.value=Y.state.spotLightMap,Ve.pointShadowMatrix.value=Y.state.pointShadowMatrix),q.numLightProbeGrids=mn(C.state.lightProbeGridArray),q.currentProgram=yt,q.uniformsList=null,yt}function _i(T,O,j,q,Y){let Ae=Ge.get(T),Ie=Ae.currentProgram.id+","+q+","+Y,Ee=Ae.programVariants.get(Ie);return Ee===void 0?(Ee=xs(T,O,j),Ae.programVariants.set(Ie,Ee)):(Ae.currentProgram=Ee,Ae.uniformsList=null,Ae.outputColorSpace=q,Ae.toneMapping=Y),Ee}function lr(T){if(T.uniformsList===null){let O=T.currentProgram.getUniforms();T.uniformsList=ma.seqWithValue(O.seq,T.uniforms)}return T.uniformsList}function wa(T,O){let j=Ge.get(T);j.outputColorSpace=O.outputColorSpace,j.batching=O.batching,j.batchingColor=O.batchingColor,j.instancing=O.instancing,j.instancingColor=O.instancingColor,j.instancingMorph=O.instancingMorph,j.skinning=O.skinning,j.morphTargets=O.morphTargets,j.morphNormals=O.morphNormals,j.morphColors=O.morphColors,j.morphTargetsCount=O.morphTargetsCount,j.numClippingPlanes=O.numClippingPlanes,j.numIntersection=O.numClipIntersection,j.vertexAlphas=O.vertexAlphas,j.vertexTangents=O.vertexTangents,j.toneMapping=O.toneMapping}function Ta(T,O,j,q,Y){O.isScene!==!0&&(O=Rn),Ye.resetTextureUnits();let Ae=O.fog,Ie=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?O.environment:null,Ee=ue===null?F.outputColorSpace:ue.isXRRenderTarget===!0?ue.texture.colorSpace:bt.workingColorSpace,Le=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,ze=R.get(q.envMap||Ie,Le),it=q.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,yt=!!j.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Ve=!!j.morphAttributes.position,vt=!!j.morphAttributes.normal,rn=!!j.morphAttributes.color,Ut=Fs;q.toneMapped&&(ue===null||ue.isXRRenderTarget===!0)&&(Ut=F.toneMapping);let kt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Pn=kt!==void 0?kt.length:0,ke=Ge.get(q),yn=C.state.lights;if(qt===!0&&(_n===!0||T!==Q)){let Ot=T===Q&&q.id===K;se.setState(q,T,Ot)}let Mt=!1,zs=!1;q.version===ke.__version?ke.needsLights&&ke.lightsStateVersion!==yn.state.version||Y.isBatchedMesh&&ke.batching===!1||!Y.isBatchedMesh&&ke.batching===!0||Y.isBatchedMesh&&ke.batchingColor===!0&&Y._colorsTexture===null||Y.isBatchedMesh&&ke.batchingColor===!1&&Y._colorsTexture!==null||Y.isInstancedMesh&&ke.instancing===!1||!Y.isInstancedMesh&&ke.instancing===!0||Y.isSkinnedMesh&&ke.skinning===!1||!Y.isSkinnedMesh&&ke.skinning===!0||Y.isInstancedMesh&&ke.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&ke.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&ke.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&ke.instancingMorph===!1&&Y.morphTexture!==null||ke.envMap!==ze||q.fog===!0&&ke.fog!==Ae||ke.numClippingPlanes!==void 0&&(ke.numClippingPlanes!==se.numPlanes||ke.numIntersection!==se.numIntersection)||ke.vertexAlphas!==it||ke.vertexTangents!==yt||ke.morphTargets!==Ve||ke.morphNormals!==vt||ke.morphColors!==rn||ke.morphTargetsCount!==Pn||ke.numLightProbeGrids!==mn(C.state.lightProbeGridArray)?Mt=!0:(ke.outputColorSpace!==Ee||ke.toneMapping!==Ut)&&(zs=!0):(Mt=!0,ke.__version=q.version);let vn=ke.currentProgram;(Mt===!0||zs===!0)&&(vn=zs===!0?_i(q,O,Y,Ee,Ut):xs(q,O,Y),G&&q.isNodeMaterial&&G.onUpdateProgram(q,vn,ke));let fo=!1,ys=!1,Gs=!1,pt=vn.getUniforms(),un=ke.uniforms;if(we.useProgram(vn.program)&&(fo=!0,ys=!0,Gs=!0),q.id!==K&&(K=q.id,ys=!0),fo||Q!==T){we.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),pt.setValue(k,"projectionMatrix",T.projectionMatrix),pt.setValue(k,"viewMatrix",T.matrixWorldInverse);let bn=pt.map.cameraPosition;bn!==void 0&&bn.setValue(k,Fn.setFromMatrixPosition(T.matrixWorld)),ut.logarithmicDepthBuffer&&pt.setValue(k,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&pt.setValue(k,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,ys=!0,Gs=!0)}if(ke.needsLights&&(yn.state.sunShadowMap.length>0&&pt.setValue(k,"sunShadowMap",yn.state.sunShadowMap,Ye),yn.state.directionalShadowMap.length>0&&pt.setValue(k,"directionalShadowMap",yn.state.directionalShadowMap,Ye),yn.state.spotShadowMap.length>0&&pt.setValue(k,"spotShadowMap",yn.state.spotShadowMap,Ye),yn.state.pointShadowMap.length>0&&pt.setValue(k,"pointShadowMap",yn.state.pointShadowMap,Ye)),Y.isSkinnedMesh){pt.setOptional(k,Y,"bindMatrix"),pt.setOptional(k,Y,"bindMatrixInverse");let Ot=Y.skeleton;Ot&&(Ot.boneTexture===null&&Ot.computeBoneTexture(),pt.setValue(k,"boneTexture",Ot.boneTexture,Ye))}Y.isBatchedMesh&&(pt.setOptional(k,Y,"batchingTexture"),pt.setValue(k,"batchingTexture",Y._matricesTexture,Ye),pt.setOptional(k,Y,"batchingIdTexture"),pt.setValue(k,"batchingIdTexture",Y._indirectTexture,Ye),pt.setOptional(k,Y,"batchingColorTexture"),Y._colorsTexture!==null&&pt.setValue(k,"batchingColorTexture",Y._colorsTexture,Ye));let ei=j.morphAttributes;if((ei.position!==void 0||ei.normal!==void 0||ei.color!==void 0)&&oe.update(Y,j,vn),(ys||ke.receiveShadow!==Y.receiveShadow)&&(ke.receiveShadow=Y.receiveShadow,pt.setValue(k,"receiveShadow",Y.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&O.environment!==null&&(un.envMapIntensity.value=O.environmentIntensity),un.dfgLUT!==void 0&&(un.dfgLUT.value=zR()),ys){if(pt.setValue(k,"toneMappingExposure",F.toneMappingExposure),ke.needsLights&&uo(un,Gs),Ae&&q.fog===!0&&xe.refreshFogUniforms(un,Ae),xe.refreshMaterialUniforms(un,q,Me,Ce,C.state.transmissionRenderTarget[T.id]),ke.needsLights&&ke.numLightProbeGrids>0){let Ot=M,bn=0;for(let qn of C.state.lightProbeGridArray)qn.texture!==null&&(Ot.textures[bn]=qn.texture,Ot.min[bn]=qn.boundingBox.min,Ot.max[bn]=qn.boundingBox.max,Ot.resolution[bn]=qn.resolution,bn++);for(let qn in Ot)Ot[qn].length=bn;un.probesSH.value=Ot.textures,un.probesMin.value=Ot.min,un.probesMax.value=Ot.max,un.probesResolution.value=Ot.resolution}ma.upload(k,lr(ke),un,Ye)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(ma.upload(k,lr(ke),un,Ye),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&pt.setValue(k,"center",Y.center),pt.setValue(k,"modelViewMatrix",Y.modelViewMatrix),pt.setValue(k,"normalMatrix",Y.normalMatrix),pt.setValue(k,"modelMatrix",Y.matrixWorld),q.uniformsGroups!==void 0){let Ot=q.uniformsGroups;for(let bn=0,qn=Ot.length;bn<qn;bn++){let Hl=Ot[bn];$e.update(Hl,vn),$e.bind(Hl,vn)}}return vn}function uo(T,O){T.ambientLightColor.needsUpdate=O,T.lightProbe.needsUpdate=O,T.sunLights.needsUpdate=O,T.sunLightShadows.needsUpdate=O,T.directionalLights.needsUpdate=O,T.directionalLightShadows.needsUpdate=O,T.pointLights.needsUpdate=O,T.pointLightShadows.needsUpdate=O,T.spotLights.needsUpdate=O,T.spotLightShadows.needsUpdate=O,T.rectAreaLights.needsUpdate=O,T.hemisphereLights.needsUpdate=O}function cr(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ue},this.setRenderTargetTextures=function(T,O,j){let q=Ge.get(T);q.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),Ge.get(T.texture).__webglTexture=O,Ge.get(T.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:j,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,O){let j=Ge.get(T);j.__webglFramebuffer=O,j.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(T,O=0,j=0){ue=T,Z=O,z=j;let q=null,Y=!1,Ae=!1;if(T){let Ee=Ge.get(T);if(Ee.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(k.FRAMEBUFFER,Ee.__webglFramebuffer),re.copy(T.viewport),fe.copy(T.scissor),de=T.scissorTest,we.viewport(re),we.scissor(fe),we.setScissorTest(de),K=-1;return}else if(Ee.__webglFramebuffer===void 0)Ye.setupRenderTarget(T);else if(Ee.__hasExternalTextures)Ye.rebindTextures(T,Ge.get(T.texture).__webglTexture,Ge.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let it=T.depthTexture;if(Ee.__boundDepthTexture!==it){if(it!==null&&Ge.has(it)&&(T.width!==it.image.width||T.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(T)}}let Le=T.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Ae=!0);let ze=Ge.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(ze[O])?q=ze[O][j]:q=ze[O],Y=!0):T.samples>0&&Ye.useMultisampledRTT(T)===!1?q=Ge.get(T).__webglMultisampledFramebuffer:Array.isArray(ze)?q=ze[j]:q=ze,re.copy(T.viewport),fe.copy(T.scissor),de=T.scissorTest}else re.copy(We).multiplyScalar(Me).floor(),fe.copy(_t).multiplyScalar(Me).floor(),de=ft;if(j!==0&&(q=V),we.bindFramebuffer(k.FRAMEBUFFER,q)&&we.drawBuffers(T,q),we.viewport(re),we.scissor(fe),we.setScissorTest(de),Y){let Ee=Ge.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+O,Ee.__webglTexture,j)}else if(Ae){let Ee=O;for(let Le=0;Le<T.textures.length;Le++){let ze=Ge.get(T.textures[Le]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Le,ze.__webglTexture,j,Ee)}}else if(T!==null&&j!==0){let Ee=Ge.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Ee.__webglTexture,j)}K=-1};function ho(T){let O=Ge.get(T);return(O.__readFormat!==T.format||O.__readType!==T.type)&&(O.__readFormat=T.format,O.__readType=T.type,O.__formatReadable=ut.textureFormatReadable(T.format),O.__typeReadable=ut.textureTypeReadable(T.type)),O}this.readRenderTargetPixels=function(T,O,j,q,Y,Ae,Ie,Ee=0){if(!(T&&T.isWebGLRenderTarget)){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=Ge.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){we.bindFramebuffer(k.FRAMEBUFFER,Le);try{let ze=T.textures[Ee],it=ze.format,yt=ze.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ee);let Ve=ho(ze);if(Ve.__formatReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=T.width-q&&j>=0&&j<=T.height-Y&&k.readPixels(O,j,q,Y,_e.convert(it),_e.convert(yt),Ae)}finally{let ze=ue!==null?Ge.get(ue).__webglFramebuffer:null;we.bindFramebuffer(k.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(T,O,j,q,Y,Ae,Ie,Ee=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=Ge.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if(O>=0&&O<=T.width-q&&j>=0&&j<=T.height-Y){we.bindFramebuffer(k.FRAMEBUFFER,Le);let ze=T.textures[Ee],it=ze.format,yt=ze.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ee);let Ve=ho(ze);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let vt=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,vt),k.bufferData(k.PIXEL_PACK_BUFFER,Ae.byteLength,k.STREAM_READ),k.readPixels(O,j,q,Y,_e.convert(it),_e.convert(yt),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let rn=ue!==null?Ge.get(ue).__webglFramebuffer:null;we.bindFramebuffer(k.FRAMEBUFFER,rn);let Ut=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await sy(k,Ut,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,vt),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Ae),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(vt),k.deleteSync(Ut),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,O=null,j=0){let q=Math.pow(2,-j),Y=Math.floor(T.image.width*q),Ae=Math.floor(T.image.height*q),Ie=O!==null?O.x:0,Ee=O!==null?O.y:0;Ye.setTexture2D(T,0),k.copyTexSubImage2D(k.TEXTURE_2D,j,0,0,Ie,Ee,Y,Ae),we.unbindTexture()},this.copyTextureToTexture=function(T,O,j=null,q=null,Y=0,Ae=0){let Ie,Ee,Le,ze,it,yt,Ve,vt,rn,Ut=T.isCompressedTexture?T.mipmaps[Ae]:T.image;if(j!==null)Ie=j.max.x-j.min.x,Ee=j.max.y-j.min.y,Le=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,it=j.min.y,yt=j.isBox3?j.min.z:0;else{let pt=Math.pow(2,-Y);Ie=Math.floor(Ut.width*pt),Ee=Math.floor(Ut.height*pt),T.isDataArrayTexture?Le=Ut.depth:T.isData3DTexture?Le=Math.floor(Ut.depth*pt):Le=1,ze=0,it=0,yt=0}q!==null?(Ve=q.x,vt=q.y,rn=q.z):(Ve=0,vt=0,rn=0);let kt=_e.convert(O.format),Pn=_e.convert(O.type),ke;O.isData3DTexture?(Ye.setTexture3D(O,0),ke=k.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(Ye.setTexture2DArray(O,0),ke=k.TEXTURE_2D_ARRAY):(Ye.setTexture2D(O,0),ke=k.TEXTURE_2D),we.activeTexture(k.TEXTURE0),we.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,O.flipY),we.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),we.pixelStorei(k.UNPACK_ALIGNMENT,O.unpackAlignment);let yn=we.getParameter(k.UNPACK_ROW_LENGTH),Mt=we.getParameter(k.UNPACK_IMAGE_HEIGHT),zs=we.getParameter(k.UNPACK_SKIP_PIXELS),vn=we.getParameter(k.UNPACK_SKIP_ROWS),fo=we.getParameter(k.UNPACK_SKIP_IMAGES);we.pixelStorei(k.UNPACK_ROW_LENGTH,Ut.width),we.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ut.height),we.pixelStorei(k.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(k.UNPACK_SKIP_ROWS,it),we.pixelStorei(k.UNPACK_SKIP_IMAGES,yt);let ys=T.isDataArrayTexture||T.isData3DTexture,Gs=O.isDataArrayTexture||O.isData3DTexture;if(T.isDepthTexture){let pt=Ge.get(T),un=Ge.get(O),ei=Ge.get(pt.__renderTarget),Ot=Ge.get(un.__renderTarget);we.bindFramebuffer(k.READ_FRAMEBUFFER,ei.__webglFramebuffer),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,Ot.__webglFramebuffer);for(let bn=0;bn<Le;bn++)ys&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ge.get(T).__webglTexture,Y,yt+bn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ge.get(O).__webglTexture,Ae,rn+bn)),k.blitFramebuffer(ze,it,ze+Ie,it+Ee,Ve,vt,Ve+Ie,vt+Ee,k.DEPTH_BUFFER_BIT,k.NEAREST);we.bindFramebuffer(k.READ_FRAMEBUFFER,null),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Y!==0||T.isRenderTargetTexture||Ge.has(T)){let pt=Ge.get(T),un=Ge.get(O);we.bindFramebuffer(k.READ_FRAMEBUFFER,N),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,W);for(let ei=0;ei<Le;ei++)ys?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,pt.__webglTexture,Y,yt+ei):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,pt.__webglTexture,Y),Gs?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,un.__webglTexture,Ae,rn+ei):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,un.__webglTexture,Ae),Y!==0?k.blitFramebuffer(ze,it,ze+Ie,it+Ee,Ve,vt,Ve+Ie,vt+Ee,k.COLOR_BUFFER_BIT,k.NEAREST):Gs?k.copyTexSubImage3D(ke,Ae,Ve,vt,rn+ei,ze,it,Ie,Ee):k.copyTexSubImage2D(ke,Ae,Ve,vt,ze,it,Ie,Ee);we.bindFramebuffer(k.READ_FRAMEBUFFER,null),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Gs?T.isDataTexture||T.isData3DTexture?k.texSubImage3D(ke,Ae,Ve,vt,rn,Ie,Ee,Le,kt,Pn,Ut.data):O.isCompressedArrayTexture?k.compressedTexSubImage3D(ke,Ae,Ve,vt,rn,Ie,Ee,Le,kt,Ut.data):k.texSubImage3D(ke,Ae,Ve,vt,rn,Ie,Ee,Le,kt,Pn,Ut):T.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Ae,Ve,vt,Ie,Ee,kt,Pn,Ut.data):T.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Ae,Ve,vt,Ut.width,Ut.height,kt,Ut.data):k.texSubImage2D(k.TEXTURE_2D,Ae,Ve,vt,Ie,Ee,kt,Pn,Ut);we.pixelStorei(k.UNPACK_ROW_LENGTH,yn),we.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Mt),we.pixelStorei(k.UNPACK_SKIP_PIXELS,zs),we.pixelStorei(k.UNPACK_SKIP_ROWS,vn),we.pixelStorei(k.UNPACK_SKIP_IMAGES,fo),Ae===0&&O.generateMipmaps===!0&&O.mipmapsAutoUpdate===!0&&k.generateMipmap(ke),we.unbindTexture()},this.initRenderTarget=function(T){Ge.get(T).__webglFramebuffer===void 0&&Ye.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Ye.setTextureCube(T,0):T.isData3DTexture?Ye.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Ye.setTexture2DArray(T,0):Ye.setTexture2D(T,0),we.unbindTexture()},this.resetState=function(){Z=0,z=0,ue=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Zi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=bt._getDrawingBufferColorSpace(e),t.unpackColorSpace=bt._getUnpackColorSpace()}};var Oh=0,GR=1,HR=new X,$y=new yl,im=new Pi,Xy=new X,kh=new Ps,Bh=class{constructor(){this.tolerance=-1,this.faces=[],this.newFaces=[],this.assigned=new Vh,this.unassigned=new Vh,this.vertices=[]}setFromPoints(e){if(e.length>=4){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.vertices.push(new sm(e[t]));this._compute()}return this}setFromObject(e){let t=[];return e.updateMatrixWorld(!0),e.traverse(function(i){let s=i.geometry;if(s!==void 0){let r=s.attributes.position;if(r!==void 0)for(let o=0,a=r.count;o<a;o++){let l=new X;l.fromBufferAttribute(r,o).applyMatrix4(i.matrixWorld),t.push(l)}}}),this.setFromPoints(t)}containsPoint(e){let t=this.faces;for(let i=0,s=t.length;i<s;i++)if(t[i].distanceToPoint(e)>this.tolerance)return!1;return!0}intersectRay(e,t){let i=this.faces,s=-1/0,r=1/0;for(let o=0,a=i.length;o<a;o++){let l=i[o],c=l.distanceToPoint(e.origin),u=l.normal.dot(e.direction);if(c>0&&u>=0)return null;let f=u!==0?-c/u:0;if(!(f<=0)&&(u>0?r=Math.min(f,r):s=Math.max(f,s),s>r))return null}return s!==-1/0?e.at(s,t):e.at(r,t),t}intersectsRay(e){return this.intersectRay(e,HR)!==null}makeEmpty(){return this.faces=[],this.vertices=[],this}_addVertexToFace(e,t){return e.face=t,t.outside===null?this.assigned.append(e):this.assigned.insertBefore(t.outside,e),t.outside=e,this}_removeVertexFromFace(e,t){return e===t.outside&&(e.next!==null&&e.next.face===t?t.outside=e.next:t.outside=null),this.assigned.remove(e),this}_removeAllVerticesFromFace(e){if(e.outside!==null){let t=e.outside,i=e.outside;for(;i.next!==null&&i.next.face===e;)i=i.next;return this.assigned.removeSubList(t,i),t.prev=i.next=null,e.outside=null,t}}_deleteFaceVertices(e,t){let i=this._removeAllVerticesFromFace(e);if(i!==void 0)if(t===void 0)this.unassigned.appendChain(i);else{let s=i;do{let r=s.next;t.distanceToPoint(s.point)>this.tolerance?this._addVertexToFace(s,t):this.unassigned.append(s),s=r}while(s!==null)}return this}_resolveUnassignedPoints(e){if(this.unassigned.isEmpty()===!1){let t=this.unassigned.first();do{let i=t.next,s=this.tolerance,r=null;for(let o=0;o<e.length;o++){let a=e[o];if(a.mark===Oh){let l=a.distanceToPoint(t.point);if(l>s&&(s=l,r=a),s>1e3*this.tolerance)break}}r!==null&&this._addVertexToFace(t,r),t=i}while(t!==null)}return this}_computeExtremes(){let e=new X,t=new X,i=[],s=[];for(let r=0;r<3;r++)i[r]=s[r]=this.vertices[0];e.copy(this.vertices[0].point),t.copy(this.vertices[0].point);for(let r=0,o=this.vertices.length;r<o;r++){let a=this.vertices[r],l=a.point;for(let c=0;c<3;c++)l.getComponent(c)<e.getComponent(c)&&(e.setComponent(c,l.getComponent(c)),i[c]=a);for(let c=0;c<3;c++)l.getComponent(c)>t.getComponent(c)&&(t.setComponent(c,l.getComponent(c)),s[c]=a)}return this.tolerance=3*Number.EPSILON*(Math.max(Math.abs(e.x),Math.abs(t.x))+Math.max(Math.abs(e.y),Math.abs(t.y))+Math.max(Math.abs(e.z),Math.abs(t.z))),{min:i,max:s}}_computeInitialHull(){let e=this.vertices,t=this._computeExtremes(),i=t.min,s=t.max,r=0,o=0;for(let d=0;d<3;d++){let p=s[d].point.getComponent(d)-i[d].point.getComponent(d);p>r&&(r=p,o=d)}let a=i[o],l=s[o],c,u;r=0,$y.set(a.point,l.point);for(let d=0,p=this.vertices.length;d<p;d++){let m=e[d];if(m!==a&&m!==l){$y.closestPointToPoint(m.point,!0,Xy);let v=Xy.distanceToSquared(m.point);v>r&&(r=v,c=m)}}r=-1,im.setFromCoplanarPoints(a.point,l.point,c.point);for(let d=0,p=this.vertices.length;d<p;d++){let m=e[d];if(m!==a&&m!==l&&m!==c){let v=Math.abs(im.distanceToPoint(m.point));v>r&&(r=v,u=m)}}let f=[];if(im.distanceToPoint(u.point)<0){f.push(ms.create(a,l,c),ms.create(u,l,a),ms.create(u,c,l),ms.create(u,a,c));for(let d=0;d<3;d++){let p=(d+1)%3;f[d+1].getEdge(2).setTwin(f[0].getEdge(p)),f[d+1].getEdge(1).setTwin(f[p+1].getEdge(0))}}else{f.push(ms.create(a,c,l),ms.create(u,a,l),ms.create(u,l,c),ms.create(u,c,a));for(let d=0;d<3;d++){let p=(d+1)%3;f[d+1].getEdge(2).setTwin(f[0].getEdge((3-d)%3)),f[d+1].getEdge(0).setTwin(f[p+1].getEdge(1))}}for(let d=0;d<4;d++)this.faces.push(f[d]);for(let d=0,p=e.length;d<p;d++){let m=e[d];if(m!==a&&m!==l&&m!==c&&m!==u){r=this.tolerance;let v=null;for(let _=0;_<4;_++){let g=this.faces[_].distanceToPoint(m.point);g>r&&(r=g,v=this.faces[_])}v!==null&&this._addVertexToFace(m,v)}}return this}_reindexFaces(){let e=[];for(let t=0;t<this.faces.length;t++){let i=this.faces[t];i.mark===Oh&&e.push(i)}return this.faces=e,this}_nextVertexToAdd(){if(this.assigned.isEmpty()===!1){let e,t=0,i=this.assigned.first().face,s=i.outside;do{let r=i.distanceToPoint(s.point);r>t&&(t=r,e=s),s=s.next}while(s!==null&&s.face===i);return e}}_computeHorizon(e,t,i,s){this._deleteFaceVertices(i),i.mark=GR;let r;t===null?r=t=i.getEdge(0):r=t.next;do{let o=r.twin,a=o.face;a.mark===Oh&&(a.distanceToPoint(e)>this.tolerance?this._computeHorizon(e,o,a,s):s.push(r)),r=r.next}while(r!==t);return this}_addAdjoiningFace(e,t){let i=ms.create(e,t.tail(),t.head());return this.faces.push(i),i.getEdge(-1).setTwin(t.twin),i.getEdge(0)}_addNewFaces(e,t){this.newFaces=[];let i=null,s=null;for(let r=0;r<t.length;r++){let o=t[r],a=this._addAdjoiningFace(e,o);i===null?i=a:a.next.setTwin(s),this.newFaces.push(a.face),s=a}return i.next.setTwin(s),this}_addVertexToHull(e){let t=[];return this.unassigned.clear(),this._removeVertexFromFace(e,e.face),this._computeHorizon(e.point,null,e.face,t),this._addNewFaces(e,t),this._resolveUnassignedPoints(this.newFaces),this}_cleanup(){return this.assigned.clear(),this.unassigned.clear(),this.newFaces=[],this}_compute(){let e;for(this._computeInitialHull();(e=this._nextVertexToAdd())!==void 0;)this._addVertexToHull(e);return this._reindexFaces(),this._cleanup(),this}},ms=class n{constructor(){this.normal=new X,this.midpoint=new X,this.area=0,this.constant=0,this.outside=null,this.mark=Oh,this.edge=null}static create(e,t,i){let s=new n,r=new Dl(e,s),o=new Dl(t,s),a=new Dl(i,s);return r.next=a.prev=o,o.next=r.prev=a,a.next=o.prev=r,s.edge=r,s.compute()}getEdge(e){let t=this.edge;for(;e>0;)t=t.next,e--;for(;e<0;)t=t.prev,e++;return t}compute(){let e=this.edge.tail(),t=this.edge.head(),i=this.edge.next.head();return kh.set(e.point,t.point,i.point),kh.getNormal(this.normal),kh.getMidpoint(this.midpoint),this.area=kh.getArea(),this.constant=this.normal.dot(this.midpoint),this}distanceToPoint(e){return this.normal.dot(e)-this.constant}},Dl=class{constructor(e,t){this.vertex=e,this.prev=null,this.next=null,this.twin=null,this.face=t}head(){return this.vertex}tail(){return this.prev?this.prev.vertex:null}length(){let e=this.head(),t=this.tail();return t!==null?t.point.distanceTo(e.point):-1}lengthSquared(){let e=this.head(),t=this.tail();return t!==null?t.point.distanceToSquared(e.point):-1}setTwin(e){return this.twin=e,e.twin=this,this}},sm=class{constructor(e){this.point=e,this.prev=null,this.next=null,this.face=null}},Vh=class{constructor(){this.head=null,this.tail=null}first(){return this.head}last(){return this.tail}clear(){return this.head=this.tail=null,this}insertBefore(e,t){return t.prev=e.prev,t.next=e,t.prev===null?this.head=t:t.prev.next=t,e.prev=t,this}insertAfter(e,t){return t.prev=e,t.next=e.next,t.next===null?this.tail=t:t.next.prev=t,e.next=t,this}append(e){return this.head===null?this.head=e:this.tail.next=e,e.prev=this.tail,e.next=null,this.tail=e,this}appendChain(e){for(this.head===null?this.head=e:this.tail.next=e,e.prev=this.tail;e.next!==null;)e=e.next;return this.tail=e,this}remove(e){return e.prev===null?this.head=e.next:e.prev.next=e.next,e.next===null?this.tail=e.prev:e.next.prev=e.prev,this}removeSubList(e,t){return e.prev===null?this.head=t.next:e.prev.next=t.next,t.next===null?this.tail=e.prev:t.next.prev=e.prev,this}isEmpty(){return this.head===null}};var zh=()=>({position:[],normal:[],tone:[],lift:[],edges:[]}),am=.66;function WR(n){let e=n.map(Math.abs),t=e[0]>=e[1]&&e[0]>=e[2]?0:e[1]>=e[2]?1:2;return .5*(1+([5,1,4,2,3,0][2*t+(n[t]<0?1:0)]+1)/6)}function _a(n,e,t,i,s=0){n.position.push(...e),n.normal.push(...t),n.tone.push(i),n.lift.push(s)}function mi(n,e,t,i=0,s=i){n.edges.push(...e,i,...t,s)}var gs=(n,e)=>[Math.cos(2*Math.PI*n/e),0,Math.sin(2*Math.PI*n/e)];function qy(n,e,t){for(let i=0;i<8;++i){let[s,r,o]=[i&1?-1:1,i&2?-1:1,i&4?-1:1],a=s*r*o>0?1:am,l=(u,f)=>di([s*(e-u-f),r*u,o*f],[0,1,0]),c=(u,f,d)=>{let p=s*r*o>0?[u,f,d].reverse():[u,f,d];for(let m of p)_a(n,m,m,a,t?r:0)};for(let u=0;u<e;++u)for(let f=0;f<e-u;++f)c(l(u,f),l(u,f+1),l(u+1,f)),u+f+2<=e&&c(l(u+1,f),l(u,f+1),l(u+1,f+1))}}function $R(n){let e=zh();qy(e,n,!1);let t=6*n;for(let i=0;i<t;++i){let[s,r]=[gs(i,t),gs(i+1,t)];mi(e,s,r),mi(e,[s[0],s[2],0],[r[0],r[2],0]),mi(e,[0,s[0],s[2]],[0,r[0],r[2]])}return e}function XR(n){let e=zh();qy(e,n,!0);let t=8*n;for(let i=0;i<t;++i){let[s,r]=[gs(i,t),gs(i+1,t)],o=Math.floor(4*i/t)%2?am:1;for(let[a,l]of[[s,-1],[s,1],[r,1],[s,-1],[r,1],[r,-1]])_a(e,a,a,o,l);mi(e,s,r,1),mi(e,s,r,-1)}for(let i=0;i<24;++i){let[s,r]=[gs(i,48),gs(i+1,48)];for(let o of[1,-1])mi(e,[s[0],o*s[2],0],[r[0],o*r[2],0],o),mi(e,[0,o*s[2],s[0]],[0,o*r[2],r[0]],o)}for(let i=0;i<4;++i)mi(e,gs(i,4),gs(i,4),-1,1);return e}function rm(n,e,t,i){let s=zh(),r=(1-i)/(t-e);for(let o=0;o<n;++o){let a=Math.floor(4*o/n)%2?am:1,[l,c]=[gs(o,n),gs(o+1,n)],u=(d,p,m)=>[p*d[0],m,p*d[2]],f=d=>di([d[0],r,d[2]],d);if(t>e)for(let[d,p]of[[l,e],[l,t],[c,t],[l,e],[c,t],[c,e]])_a(s,u(d,p===t?i:1,p),f(d),a);for(let d of[[0,e,0],u(l,1,e),u(c,1,e)])_a(s,d,[0,-1,0],.8*a);if(mi(s,u(l,1,e),u(c,1,e)),i>0){for(let d of[[0,t,0],u(c,i,t),u(l,i,t)])_a(s,d,[0,1,0],.9*a);mi(s,u(l,i,t),u(c,i,t))}}for(let o=0;o<4;++o){let a=gs(o,4);mi(s,[a[0],e,a[2]],[i*a[0],t,i*a[2]])}return s}function qR(n){let e=new Map,t=i=>i.map(s=>Math.fround(s)).join();for(let i=0;i<n.position.length;i+=9){let s=[0,1,2].map(o=>n.position.slice(i+3*o,i+3*o+3)),r=di(qs(mt(s[1],s[0]),mt(s[2],s[0])),[0,1,0]);for(let o=0;o<3;++o){let[a,l]=[s[o],s[(o+1)%3]],c=t(a)<t(l)?`${t(a)} ${t(l)}`:`${t(l)} ${t(a)}`,u=e.get(c);u?(++u.count,xt(r,u.n)<Math.cos(Math.PI/9)&&!u.drawn&&(u.drawn=!0,mi(n,a,l))):e.set(c,{n:r,drawn:!1,a,b:l,count:1})}}for(let i of e.values())i.count===1&&mi(n,i.a,i.b)}function Gh(n){let e=zh();for(let[t,i,s]of n){let r=di(qs(mt(i,t),mt(s,t)),[0,0,0]);if(Tt(r)!==0)for(let o of[t,i,s])_a(e,o,r,WR(r))}return qR(e),e}function Yy(n){let e=n.filter(i=>i.every(Number.isFinite)),t=[];if(e.length<4)return t;for(let i of new Bh().setFromPoints(e.map(s=>new X(...s))).faces){let s=[],r=i.edge;do{let o=r.head().point;s.push([o.x,o.y,o.z]),r=r.next}while(r!==i.edge);for(let o=2;o<s.length;++o)t.push([s[0],s[o-1],s[o]])}return t}function om(){let n=[];for(let e=0;e<3;++e)for(let t of[1,-1]){let i=(s,r)=>{let o=[0,0,0];return o[e]=t,o[(e+1)%3]=s,o[(e+2)%3]=r*t,o};n.push([i(-1,-1),i(1,-1),i(1,1)],[i(-1,-1),i(1,1),i(-1,1)])}return Gh(n)}function YR(){let n=om();n.position=n.position.map(e=>.3*e),n.edges=[];for(let e=0;e<3;++e){let t=om();for(let r=0;r<t.position.length;++r){let o=r%3===e,a=t.position[r];t.position[r]=o?a>0?1:-.5:.09*a}n.position.push(...t.position),n.normal.push(...t.normal),n.tone.push(...t.tone.map(r=>[1,.8,.6][e]*(.5+.5*r))),n.lift.push(...t.lift);let[i,s]=[[0,0,0],[0,0,0]];i[e]=-.5,s[e]=1,mi(n,i,s)}return n}function Jy(n,e){let t=e<=60?8:e<=300?5:3,i=4*t;return{sphere:()=>$R(t),box:om,capsule:()=>XR(t),cylinder:()=>rm(i,-1,1,1),cone:()=>rm(i,-.25,.75,0),disc:()=>rm(i,0,0,1),cross:YR}[n]()}function lm(n){return n.reduce((e,t)=>e.map((i,s)=>Math.max(i,Math.abs(t[s]))),nt([1,1,1],0))}var JR=[1,0,0,0],Zy=-1,xa=n=>[n,n,n];function Ky(n,e){let t={molds:new Map,pieces:[],radius:[]},i=n.body.length,s=(a,l,c,u,f,d)=>{t.molds.has(l)||t.molds.set(l,Jy(l,i)),t.pieces.push({body:a,mold:l,size:c,half:u,position:f,orientation:d})},r=(a,l,c,u,f,d)=>{t.molds.has(l)||t.molds.set(l,c()),t.molds.get(l).position.length===0?s(a,"cross",[...xa(Tt(u)||e),Zy],u,f,d):t.pieces.push({body:a,mold:l,size:[1,1,1,0],half:u,position:f,orientation:d})},o=(a,l,c,u)=>{if(!l)return s(a,"cross",[...xa(e),Zy],xa(e),c,u);switch(l.type){case"sphere":return s(a,"sphere",[...xa(l.radius),0],xa(l.radius),c,u);case"box":return s(a,"box",[...l.half_extents,0],l.half_extents,c,u);case"capsule":{let{radius:f,length:d}=l;return s(a,"capsule",[f,f,f,d/2],[f,f+d/2,f],c,u)}case"cylinder":{let{radius:f,length:d}=l;return s(a,"cylinder",[f,d/2,f,0],[f,d/2,f],c,u)}case"cone":{let{radius:f,length:d}=l;return s(a,"cone",[f,d,f,0],[f,.75*d,f],c,u)}case"rod":{let f=.012*l.length;return s(a,"cylinder",[f,l.length/2,f,0],[f,l.length/2,f],c,u)}case"disc":return s(a,"disc",[...xa(l.radius),0],[l.radius,.02*l.radius,l.radius],c,u);case"hull":return r(a,`hull ${l.vertices.join()}`,()=>Gh(Yy(l.vertices)),lm(l.vertices),c,u);case"mesh":{let f=p=>l.vertices[p]??[0,0,0],d=()=>Gh(l.faces.map(([p,m,v])=>[f(p),f(m),f(v)]));return r(a,`mesh ${l.vertices.join()} ${l.faces.join()}`,d,lm(l.vertices),c,u)}case"compound":for(let f of l.parts)o(a,f.shape,je(c,Yt(u,f.position)),yr(u,f.orientation))}};n.body.forEach((a,l)=>o(l,Uo(a),[0,0,0],JR)),t.radius=n.body.map(()=>0);for(let a of t.pieces)t.radius[a.body]=Math.max(t.radius[a.body],Tt(a.position)+Tt(a.half));return t}function jy(n){let e=new Map;for(let t of n.pieces){let i=e.get(t.mold);i?i.push(t):e.set(t.mold,[t])}return e}function Qy(n,e){let t=Math.floor(n.length/(3*e)),i=Math.max(1,Math.ceil(t*e/15e4)),s=Math.floor((t-1)/i)+1;return{source:n,positions:new Float32Array(3*e*s),bodies:e,frames:s,every:i,filled:0,upTo:0}}function ev(n,e){let{source:t,positions:i,bodies:s,every:r}=n;for(n.upTo=Math.max(0,Math.min(Math.floor(e/r),n.frames-1));n.filled<=n.upTo;++n.filled){let o=n.filled;for(let a=0;a<s;++a){let l=3*(o*r*s+a),c=3*(o*s+a),u=Number.isFinite(t[l]+t[l+1]+t[l+2]);if(u&&o>0&&Number.isNaN(i[c-3*s]))for(let f=c-3*s;f>=0;f-=3*s)i.set(t.subarray(l,l+3),f);for(let f=0;f<3;++f)i[c+f]=u?t[l+f]:o>0?i[c+f-3*s]:NaN}}}var Hh=class{constructor(e){this.count=e;this.position=new Float64Array(3*e),this.orientation=new Float64Array(4*e),this.hidden=new Uint8Array(e)}count;position;orientation;hidden;shown=!1;version=0;set(e){if(++this.version,this.shown=e!==null,!!e)for(let t=0;t<this.count;++t){let i=0;for(let o=3*t;o<3*t+3;++o)i+=this.position[o]=e.position[o]??NaN;let s=0;for(let o=4*t;o<4*t+4;++o)s+=(this.orientation[o]=e.orientation[o]??NaN)**2;let r=1/Math.sqrt(s);this.hidden[t]=Number.isFinite(i)&&Math.abs(i)<1e30&&Number.isFinite(r)?0:1;for(let o=4*t;o<4*t+4;++o)this.orientation[o]*=r}}at(e){return[this.position[3*e],this.position[3*e+1],this.position[3*e+2]]}turn(e){let t=this.orientation;return[t[4*e],t[4*e+1],t[4*e+2],t[4*e+3]]}},Nl=class{constructor(e,t,i){this.scene=e;this.theme=t;this.bounds=ko(e,i),this.extent=Math.max(Tt(mt(this.bounds.max,this.bounds.min)),1e-9),this.solids=Ky(e,.035*this.extent);let s=[...this.solids.radius].sort((r,o)=>r-o);this.typical=s[s.length>>1]??this.extent,this.colours=e.body.map(D_),this.joined=new kc(e,this.extent),this.layers={bodies:new Hh(e.body.length),ghost:new Hh(e.body.length)},this.layers.bodies.set({position:e.body.flatMap(r=>r.position),orientation:e.body.flatMap(r=>r.orientation)})}scene;theme;bounds;extent;typical;solids;colours;layers;trails={bodies:null,ghost:null};fixed=new Bo;links=new Bo;marks=new Bo;time=0;arrows=[];pulls=[];linksShown=!0;grid=0;planesFor=null;contacts=[];largestImpulse=0;joined;setEye(e,t){let i=J_(this.scene,e),{theme:s}=this,r=this.planesFor;r?.theme===s&&r.held===t&&i.every((o,a)=>o===r.open[a])||(this.planesFor={theme:s,held:t,open:i},this.grid=Vf(Tt(mt(t.max,t.min))),this.fixed.clear(),Z_(this.fixed,this.scene,t,s,i))}relink(){this.links.clear(),this.marks.clear();let e=this.layers.bodies.shown?this.layers.bodies:this.layers.ghost;this.linksShown&&e.shown&&this.joined.draw(this,e),X_(this,this.contacts,this.largestImpulse),$_(this,this.arrows),q_(this,this.pulls)}setContacts(e,t){if(this.contacts=e,t!==void 0)this.largestImpulse=t;else for(let{impulse:i}of e)Number.isFinite(i)&&(this.largestImpulse=Math.max(this.largestImpulse,i))}setTrail(e,t,i,s){let r=this.trails[e];if(!t||i<1||t.length<6*i){this.trails[e]=null;return}let o=r?.source===t&&r.bodies===i?r:Qy(t,i);ev(o,s),this.trails[e]=o}lost(){let{shown:e,hidden:t}=this.layers.bodies;return e?this.scene.body.filter((i,s)=>t[s]).map(i=>i.name):[]}};function tv(n,e){let t=e.turn(n.body);return{centre:je(e.at(n.body),Yt(t,n.position)),turn:yr(t,n.orientation)}}function cm({centre:n,turn:e},t,i,s,r,o){let[a,l,c,u]=t.size;return je(n,Yt(e,[a*i,l*s+u*o,c*r]))}var um=(n,e,t)=>Ti(n.map(i=>i*e*t)),ZR=(n,e)=>.62+.38*(-.34*xt(e,n.right)+.63*xt(e,n.up)+.68*xt(e,n.back));function nv(n,e){let t=[],i=n.layers.bodies,s=1/cs(e);for(let r of n.solids.pieces){if(i.hidden[r.body])continue;let o=tv(r,i),a=n.colours[r.body],{x:l,y:c,depth:u}=Ai(e,o.centre),f=n.solids.molds.get(r.mold),d=s*Math.max(...r.half);d<2.5?t.push({depth:u,draw:p=>iv(p,l,c,2.5,Ti(a))}):r.mold==="sphere"?t.push({depth:u,draw:p=>KR(p,e,f,r,o,a,l,c,d)}):jR(t,e,f,r,o,a)}return t}function iv(n,e,t,i,s){n.fillStyle=s,n.beginPath(),n.arc(e,t,i,0,2*Math.PI),n.fill()}function KR(n,e,t,i,s,r,o,a,l){iv(n,o,a,l,um(r,.95,.85)),!(l<5)&&(n.strokeStyle=um(r,.5,.9),n.lineWidth=Math.min(2,l/6),n.beginPath(),sv(n,e,t,i,s,!0),n.stroke())}function sv(n,e,{edges:t},i,s,r){for(let o=0;o<t.length;o+=8){let a=cm(s,i,t[o],t[o+1],t[o+2],t[o+3]),l=cm(s,i,t[o+4],t[o+5],t[o+6],t[o+7]);if(r&&xt(mt(je(a,l),je(s.centre,s.centre)),e.back)<0)continue;let[c,u]=[Ai(e,a),Ai(e,l)];n.moveTo(c.x,c.y),n.lineTo(u.x,u.y)}}function jR(n,e,t,i,s,r){let[o,a,l]=i.size,c=Math.max(...i.half)>10*cs(e);for(let u=0;u<t.tone.length;u+=3){let f=Yt(s.turn,[t.normal[3*u]/(o||1),t.normal[3*u+1]/(a||1),t.normal[3*u+2]/(l||1)]),d=Math.hypot(...f)||1,p=[0,1,2].map(y=>{let E=3*(u+y);return Ai(e,cm(s,i,t.position[E],t.position[E+1],t.position[E+2],t.lift[u+y]))}),[m,v,_]=p;if((v.x-m.x)*(_.y-m.y)-(v.y-m.y)*(_.x-m.x)>=0)continue;let g=um(r,t.tone[u],ZR(e,[f[0]/d,f[1]/d,f[2]/d]));n.push({depth:(m.depth+v.depth+_.depth)/3,draw:y=>{y.fillStyle=g,y.beginPath();for(let{x:E,y:M}of p)y.lineTo(E,M);y.closePath(),y.fill(),c&&(y.strokeStyle=g,y.lineWidth=.7,y.stroke())}})}}function rv(n,e,t){let i=n.layers.ghost;t.strokeStyle=Ti(n.theme.ink),t.lineWidth=1,t.setLineDash([4,3]),t.beginPath();for(let s of n.solids.pieces){if(i.hidden[s.body])continue;let r=tv(s,i),{x:o,y:a}=Ai(e,r.centre);if(s.mold==="sphere"){let l=Math.max(s.half[0]/cs(e),4);t.moveTo(o+l,a),t.arc(o,a,l,0,2*Math.PI)}else sv(t,e,n.solids.molds.get(s.mold),s,r,!1)}t.stroke(),t.setLineDash([])}var ov=n=>Math.min(Math.max(Math.trunc((n- -5)/.25),0),40);function av(n,e,t,i){if(n.mode!=="step")return n.level+n.wave*Math.sin(e-n.speed*i);let[s,r]=[ov(e),ov(t)];return n.level+n.wave/2*(Math.sin(n.speed*i+s)+Math.sin(s*r/2))}function lv(n,e){let t=new Float32Array(4*(e+1)**2),i=new Uint32Array(6*e*e),s=1.3*Math.max(n.max[0]-n.min[0],n.max[2]-n.min[2],.6*(n.max[1]-n.min[1])),r=(n.min[0]+n.max[0]-s)/2,o=(n.min[2]+n.max[2]-s)/2;for(let a=0;a<=e;++a)for(let l=0;l<=e;++l)t.set([r+s*a/e,o+s*l/e,0,0],4*(a*(e+1)+l));for(let a=0;a<e;++a)for(let l=0;l<e;++l){let c=a*(e+1)+l;i.set([c,c+1,c+e+2,c,c+e+2,c+e+1],6*(a*e+l))}return{place:t,index:i}}function cv(){let e=new Float32Array(79376),t=new Uint32Array(6*4961),i=0,s=(...r)=>{r.forEach((o,a)=>e.set(o,16*i+4*a)),t.set([4*i,4*i+1,4*i+2,4*i,4*i+2,4*i+3],6*i),++i};for(let r=0;r<41;++r)for(let o=0;o<41;++o){let[a,l]=[-5+.25*r,-5+.25*o],[c,u]=[a+.25,l+.25];s([a,l,r,o],[a,u,r,o],[c,u,r,o],[c,l,r,o]),r+1<41&&s([c,l,r,o],[c,u,r,o],[c,u,r+1,o],[c,l,r+1,o]),o+1<41&&s([a,u,r,o],[c,u,r,o],[c,u,r,o+1],[a,u,r,o+1])}return{place:e,index:t}}var QR=["bodies","ghost"],Wh=class{constructor(e){this.canvas=e;this.context=e.getContext("2d",{willReadFrequently:!0})}canvas;webgl=!1;lost=!1;onChange=null;picture=null;context;show(e){this.picture=e}draw(e){let t=this.picture;if(!t)return;let{context:i,canvas:s}=this,[r,o]=[Math.max(1,Math.round(e.width*e.ratio)),Math.max(1,Math.round(e.height*e.ratio))];(s.width!==r||s.height!==o)&&([s.width,s.height]=[r,o]),i.setTransform(e.ratio,0,0,e.ratio,0,0),i.fillStyle=Ti(t.theme.ground),i.fillRect(0,0,e.width,e.height),i.lineCap=i.lineJoin="round";for(let c=0;c<t.fixed.count;++c)this.segment(e,t.fixed,c);for(let c of QR)this.trail(e,t,t.trails[c],c==="ghost");let a=t.layers.bodies.shown?nv(t,e):[],{links:l}=t;for(let c=0;c<l.count;++c)a.push({depth:this.depth(e,l,c),draw:()=>this.segment(e,l,c)});this.water(a,e,t),a.sort((c,u)=>u.depth-c.depth);for(let c of a)c.draw(i);t.layers.ghost.shown&&rv(t,e,i);for(let c=0;c<t.marks.count;++c)this.segment(e,t.marks,c)}depth(e,{data:t},i){let s=i*12,r=[t[s]+t[s+3],t[s+1]+t[s+4],t[s+2]+t[s+5]];return Ai(e,[r[0]/2,r[1]/2,r[2]/2]).depth}segment(e,{data:t},i){let s=this.context,r=i*12,o=Ai(e,[t[r],t[r+1],t[r+2]]),a=Ai(e,[t[r+3],t[r+4],t[r+5]]),l=Ti([t[r+6],t[r+7],t[r+8]]),[c,u,f]=[t[r+9],t[r+10],t[r+11]],d=Math.hypot(a.x-o.x,a.y-o.y);if(s.fillStyle=s.strokeStyle=l,s.beginPath(),f===2)s.arc(o.x,o.y,c/2,0,2*Math.PI),s.fill();else if(c!==u){let[p,m]=d>0?[(a.y-o.y)*c/2/d,(o.x-a.x)*c/2/d]:[0,0];s.moveTo(o.x+p,o.y+m),s.lineTo(o.x-p,o.y-m),s.lineTo(a.x,a.y),s.fill()}else s.setLineDash(f===1?[5,4]:[]),s.lineWidth=c,s.moveTo(o.x,o.y),s.lineTo(a.x,a.y),s.stroke(),s.setLineDash([])}trail(e,t,i,s){if(!i)return;let r=this.context,o=i.upTo;r.lineWidth=1.5,r.setLineDash(s?[5,4]:[]);for(let a=0;a<i.bodies;++a){r.strokeStyle=Ti(t.colours[a]??t.theme.ink),r.beginPath();for(let l=0;l<=o;++l){let c=3*(l*i.bodies+a),{x:u,y:f}=Ai(e,i.positions.subarray(c,c+3));r.lineTo(u,f)}r.stroke()}r.setLineDash([])}water(e,t,{scene:i,bounds:s,theme:r,time:o}){let a=Ti(Cs([.1,.4,.8],r.ink,.1));for(let l of i.water){let c=1.3*Math.max(s.max[0]-s.min[0],s.max[2]-s.min[2]),[u,f]=[(s.min[0]+s.max[0]-c)/2,(s.min[2]+s.max[2]-c)/2];for(let d=0;d<=16;++d){let p=f+c*d/16,m=v=>{v.strokeStyle=a,v.lineWidth=1,v.beginPath();for(let _=0;_<=120;++_){let g=u+c*_/120,y=Ai(t,[g,av(l,g,p,o),p]);v.lineTo(y.x,y.y)}v.stroke()};e.push({depth:Ai(t,[u+c/2,l.level,p]).depth,draw:m})}}}dispose(){this.picture=null}};function eP(n){let e={position:[],normal:[],tone:[],lift:[],index:[]},t=new Map;for(let i=0;i<n.tone.length;++i){let s=n.position.slice(3*i,3*i+3),r=n.normal.slice(3*i,3*i+3),o=`${s} ${r} ${n.tone[i]} ${n.lift[i]}`,a=t.get(o);a===void 0&&(a=t.size,t.set(o,a),e.position.push(...s),e.normal.push(...r),e.tone.push(n.tone[i]),e.lift.push(n.lift[i])),e.index.push(a)}return e}var $h=class{constructor(e,t,i,s,r){this.pieces=t;let o=t.length;this.center=new Cr(new Float32Array(4*o),4).setUsage(oo),this.turn=new Cr(new Float32Array(4*o),4).setUsage(oo);let a=new Cr(new Float32Array(t.flatMap(_=>_.size)),4),l=new Cr(new Float32Array(t.flatMap(_=>i[_.body])),3),c=(_,g)=>{let y=new to;return y.instanceCount=o,y.setAttribute("position",new fn(new Float32Array(_),3)),y.setAttribute("lift",new fn(new Float32Array(g),1)),y.setAttribute("center",this.center),y.setAttribute("turn",this.turn),y.setAttribute("size",a),y.setAttribute("color",l),y},{position:u,normal:f,tone:d,lift:p,index:m}=eP(e),v=c(u,p);if(v.setAttribute("normal",new fn(new Float32Array(f),3)),v.setAttribute("tone",new fn(new Float32Array(d),1)),v.setIndex(m),this.drawn.push(new Xn(v,s)),r&&e.edges.length>0){let _=e.edges.filter((g,y)=>y%4<3);this.drawn.push(new fl(c(_,e.edges.filter((g,y)=>y%4===3)),r))}for(let _ of this.drawn)_.frustumCulled=_.matrixAutoUpdate=!1}pieces;drawn=[];center;turn;place(e,t,i){let s=this.center.array,r=this.turn.array;for(let o=0;o<this.pieces.length;++o){let{body:a,position:l,orientation:c}=this.pieces[o],u=4*o;if(s[u+3]=i[a]?0:1,i[a])continue;let f=t[4*a],d=t[4*a+1],p=t[4*a+2],m=t[4*a+3],v=p*l[2]-m*l[1]+f*l[0],_=m*l[0]-d*l[2]+f*l[1],g=d*l[1]-p*l[0]+f*l[2];s[u]=e[3*a]+l[0]+2*(p*g-m*_),s[u+1]=e[3*a+1]+l[1]+2*(m*v-d*g),s[u+2]=e[3*a+2]+l[2]+2*(d*_-p*v),r[u]=f*c[0]-d*c[1]-p*c[2]-m*c[3],r[u+1]=f*c[1]+d*c[0]+p*c[3]-m*c[2],r[u+2]=f*c[2]-d*c[3]+p*c[0]+m*c[1],r[u+3]=f*c[3]+d*c[2]-p*c[1]+m*c[0]}this.center.needsUpdate=this.turn.needsUpdate=!0}dispose(){for(let e of this.drawn)e.geometry.dispose()}};var Xh=`
precision highp float;
uniform mat4 view, projection;
`,uv=`
${Xh}
uniform float grow;      // part by which a ghost is larger than a body: equal poses must not fight for depth
uniform float smallest;  // least half extent, as a part of the distance: small bodies stay in sight
in vec3 position;
in float lift;
in vec4 center;
in vec4 turn;
in vec4 size;
in vec3 color;
vec3 rotated(vec3 v) { return v + 2.0 * cross(turn.yzw, cross(turn.yzw, v) + turn.x * v); }
vec4 placed() {
  float depth = max(-(view * vec4(center.xyz, 1.0)).z, 0.0);
  float half_extent = max(max(size.x, size.z), size.y + max(size.w, 0.0));
  float least = size.w < 0.0 ? 2.5 * smallest : smallest;  // crosses are thin
  float k = max(1.0 + grow, least * depth / max(half_extent, 1e-30));
  vec3 local = position * size.xyz + vec3(0.0, lift * size.w, 0.0);
  return center.w > 0.0 ? view * vec4(center.xyz + rotated(k * local), 1.0) : vec4(0.0, 0.0, 1e30, 1.0);
}
`,hm=`
${uv}
in vec3 normal;
in float tone;
out vec3 shade;
out float rim;
void main() {
  vec4 p = placed();
  gl_Position = projection * p;
  vec3 n = normalize(mat3(view) * rotated(normalize(normal / max(size.xyz, vec3(1e-30)))));
  float light = 0.62 + 0.38 * dot(n, normalize(vec3(-0.35, 0.65, 0.7)));
  shade = color * tone * light;
  rim = 1.0 - abs(dot(n, normalize(p.xyz)));
}
`,hv=`
precision highp float;
in vec3 shade;
in float rim;
out vec4 pixel;
void main() { pixel = vec4(shade, 1.0); }
`,dv=`
precision highp float;
uniform vec3 ink;
uniform float ratio;
in vec3 shade;
in float rim;
out vec4 pixel;
void main() {
  float stripe = step(0.5, fract((gl_FragCoord.x - gl_FragCoord.y) / (7.0 * ratio)));
  pixel = vec4(mix(shade, ink, 0.55), 0.08 + 0.2 * stripe + 0.45 * smoothstep(0.6, 0.95, rim));
}
`,fv=`
${uv}
void main() { gl_Position = projection * placed(); }
`,pv=`
precision highp float;
uniform vec3 ink;
uniform float ratio;
out vec4 pixel;
void main() {
  if (fract((gl_FragCoord.x + gl_FragCoord.y) / (8.0 * ratio)) > 0.6) discard;
  pixel = vec4(ink, 0.9);
}
`,mv=`
uniform vec2 pixels;  // of the drawing buffer
uniform float ratio, near, bias;
out vec3 shade;
flat out float broken;
out vec2 spot;  // within a dot: -1 \u2026 1 each way
void draw(vec3 a, vec3 b, vec2 widths, vec2 corner) {
  vec4 from = view * vec4(a, 1.0), to = view * vec4(b, 1.0);
  // What lies behind the camera is cut off at the near plane.
  if (from.z > -near && to.z > -near) { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); return; }
  if (from.z > -near) from = mix(to, from, (-near - to.z) / (from.z - to.z));
  if (to.z > -near) to = mix(from, to, (-near - from.z) / (to.z - from.z));
  vec4 p = projection * from, q = projection * to;
  vec2 along = (q.xy / q.w - p.xy / p.w) * pixels;
  float l = length(along);
  along = l > 1e-3 ? along / l : vec2(1.0, 0.0);
  float width = mix(widths.x, widths.y, corner.x) * ratio;
  if (corner.x < 0.5) width = max(width, 1.0);
  float cap = 0.5 * min(widths.x, widths.y) * ratio;
  vec2 shift = 0.5 * width * corner.y * vec2(-along.y, along.x) + (2.0 * corner.x - 1.0) * cap * along;
  spot = vec2(2.0 * corner.x - 1.0, corner.y);
  vec4 c = corner.x < 0.5 ? p : q;
  gl_Position = vec4(c.xy + 2.0 * shift / pixels * c.w, c.z - bias * c.w, c.w);
}
`,dm=`
${Xh}
${mv}
in vec3 position;  // which end, which side
in vec3 from, to, color;
in vec2 widths;
in float pattern;
void main() {
  shade = color;
  broken = pattern;
  draw(from, to, widths, position.xy);
}
`,gv=`
${Xh}
${mv}
in vec3 position;  // which end, which side
in vec3 from, to;
uniform int bodies;
uniform float dashes;
uniform sampler2D colors;
void main() {
  int body = gl_InstanceID % bodies;
  shade = texelFetch(colors, ivec2(body % 1024, body / 1024), 0).rgb;
  broken = dashes;
  draw(from, to, vec2(1.5), position.xy);
}
`,qh=`
precision highp float;
uniform float ratio;
in vec3 shade;
flat in float broken;
in vec2 spot;
out vec4 pixel;
void main() {
  if (broken > 1.5 && dot(spot, spot) > 1.0) discard;
  float dash = fract((gl_FragCoord.x + gl_FragCoord.y) / (9.0 * ratio));
  if (broken > 0.5 && broken < 1.5 && dash > 0.55) discard;
  pixel = vec4(shade, 1.0);
}
`,_v=`
${Xh}
uniform float level, wave, speed, time;
uniform bool cells;
in vec4 place;  // x, z, and the indices i, j of the cell
out float height;
void main() {
  float y = cells ? 0.5 * wave * (sin(speed * time + place.z) + sin(0.5 * place.z * place.w))
                  : wave * sin(place.x - speed * time);
  height = wave > 0.0 ? y / wave : 0.0;
  gl_Position = projection * view * vec4(place.x, level + y, place.y, 1.0);
}
`,xv=`
precision highp float;
uniform float alpha;
in float height;
out vec4 pixel;
void main() { pixel = vec4(0.08, 0.32 + 0.1 * height, 0.68 + 0.2 * height, alpha); }
`;function Yh(){let n=new to;return n.setAttribute("position",new fn(new Float32Array([0,-1,0,1,-1,0,1,1,0,0,-1,0,1,1,0,0,1,0]),3)),n}var ya=class{constructor(e,t,i){this.lines=e;this.drawn=new Xn(Yh(),t),this.drawn.frustumCulled=this.drawn.matrixAutoUpdate=!1,this.drawn.renderOrder=i}lines;drawn;version=-1;buffer=null;sync(){if(this.version===this.lines.version)return;this.version=this.lines.version,this.buffer?.array!==this.lines.data&&this.attach();let e=this.drawn.geometry;e.instanceCount=this.lines.count,this.drawn.visible=this.lines.count>0,this.buffer.clearUpdateRanges(),this.buffer.addUpdateRange(0,this.lines.count*12),this.buffer.needsUpdate=!0}attach(){let e=this.drawn.material;this.drawn.geometry.dispose();let t=Yh();this.buffer=new ua(this.lines.data,12),this.buffer.setUsage(oo);let i=(s,r,o)=>{t.setAttribute(s,new jr(this.buffer,r,o))};i("from",3,0),i("to",3,3),i("color",3,6),i("widths",2,9),i("pattern",1,11),this.drawn.geometry=t,this.drawn.material=e}dispose(){this.drawn.geometry.dispose()}},fm=1024;function yv(n){let e=Math.max(1,Math.ceil(n.length/fm)),t=new Float32Array(4*fm*e);n.forEach((s,r)=>t.set([...s,1],4*r));let i=new oa(t,fm,e,ki,Ui);return i.needsUpdate=!0,i}var Jh=class{constructor(e){this.material=e;this.drawn=new Xn(Yh(),e),this.drawn.frustumCulled=this.drawn.matrixAutoUpdate=!1,this.drawn.renderOrder=2,this.drawn.visible=!1}material;drawn;trail=null;buffer=null;sent=0;sync(e){if(this.drawn.visible=e!==null&&e.upTo>0,!!e){if(this.trail!==e&&this.attach(e),this.sent<e.filled){let t=3*e.bodies;this.buffer.clearUpdateRanges(),this.buffer.addUpdateRange(this.sent*t,(e.filled-this.sent)*t),this.buffer.needsUpdate=!0,this.sent=e.filled}this.drawn.geometry.instanceCount=e.bodies*e.upTo}}attach(e){this.trail=e,this.sent=0,this.drawn.geometry.dispose();let t=Yh();this.buffer=new ua(e.positions,3),this.buffer.setUsage(oo),t.setAttribute("from",new jr(this.buffer,3,0));let i=3*e.bodies;t.setAttribute("to",new jr(this.buffer,3,i)),this.drawn.geometry=t,this.material.uniforms.bodies.value=e.bodies}dispose(){this.drawn.geometry.dispose()}};function vv(n,e,t){let i=new Ki,{place:s,index:r}=n.mode==="step"?cv():lv(e,80);i.setAttribute("place",new fn(s,4)),i.setIndex(new fn(r,1));let o=new Xn(i,t);return o.frustumCulled=o.matrixAutoUpdate=!1,o}bt.enabled=!1;var Zh=["bodies","ghost"],Kh=class{constructor(e,t){this.canvas=e;this.renderer=new Nh({canvas:e,context:t}),this.renderer.outputColorSpace=Zr,this.renderer.sortObjects=!0,this.scene.matrixWorldAutoUpdate=!1,this.camera.matrixWorldAutoUpdate=!1,e.addEventListener("webglcontextlost",this.onLost),e.addEventListener("webglcontextrestored",this.onRestored)}canvas;webgl=!0;lost=!1;onChange=null;renderer;camera=new eo;common={view:{value:new Jt},projection:{value:new Jt},pixels:{value:new Et(1,1)},ratio:{value:1},near:{value:.1},smallest:{value:0},ink:{value:new X}};materials={body:this.material(hm,hv,{grow:0},{}),ghost:this.material(hm,dv,{grow:.008},{transparent:!0,depthWrite:!1}),edge:this.material(fv,pv,{grow:.012},{transparent:!0,depthWrite:!1}),line:this.material(dm,qh,{bias:1e-4},{}),mark:this.material(dm,qh,{bias:0},{depthTest:!1,transparent:!0})};picture=null;scene=new cl;batches={bodies:[],ghost:[]};placed={bodies:-1,ghost:-1};strips=[];trails=null;waters=[];colours=null;onLost=e=>{e.preventDefault(),this.lost=!0,this.clear();for(let t of Object.values(this.materials))t.dispose();this.onChange?.()};onRestored=()=>{this.lost=!1,this.picture&&this.show(this.picture),this.onChange?.()};material(e,t,i,s){let r={...this.common};for(let[o,a]of Object.entries(i))r[o]={value:a};return new la({glslVersion:Cl,vertexShader:e,fragmentShader:t,uniforms:r,...s})}show(e){if(this.clear(),this.picture=e,this.lost)return;let t=e.colours,i=jy(e.solids);for(let a of Zh){let l=a==="ghost",c=l?this.materials.ghost:this.materials.body;for(let[u,f]of i){let d=new $h(e.solids.molds.get(u),f,t,c,l?this.materials.edge:null);for(let p of d.drawn)p.renderOrder=l?6:0,this.scene.add(p);this.batches[a].push(d)}}this.placed={bodies:-1,ghost:-1};let{line:s,mark:r}=this.materials;this.strips=[new ya(e.fixed,s,1),new ya(e.links,s,2),new ya(e.marks,r,9)];for(let a of this.strips)this.scene.add(a.drawn);this.colours=yv(t);let o=a=>new Jh(this.material(gv,qh,{bias:1e-4,bodies:1,dashes:a,colors:this.colours},{}));this.trails={bodies:o(0),ghost:o(1)};for(let a of Zh)this.scene.add(this.trails[a].drawn);for(let a of e.scene.water){let{level:l,wave:c,speed:u}=a,f={level:l,wave:c,speed:u,time:0,cells:a.mode==="step",alpha:.55};for(let d of[!1,!0]){let p=this.material(_v,xv,f,{transparent:!0,side:ji,colorWrite:d}),m=vv(a,e.bounds,p);m.renderOrder=d?8:7,this.waters.push({mesh:m,material:p}),this.scene.add(m)}}}look(e){let{right:t,up:i,back:s,eye:r,near:o,far:a,width:l,height:c,ratio:u}=e,f=this.common;f.view.value.set(t[0],t[1],t[2],-xt(t,r),i[0],i[1],i[2],-xt(i,r),s[0],s[1],s[2],-xt(s,r),0,0,0,1);let d=1/Math.tan($a/2),p=1/(o-a);f.projection.value.set(d*c/l,0,0,0,0,d,0,0,0,0,(o+a)*p,2*o*a*p,0,0,-1,0);let[m,v]=[Math.max(1,Math.round(l*u)),Math.max(1,Math.round(c*u))];(this.canvas.width!==m||this.canvas.height!==v)&&this.renderer.setSize(m,v,!1),f.pixels.value.set(m,v),f.ratio.value=u,f.near.value=o,f.smallest.value=6/d/c,f.ink.value.set(...this.picture.theme.ink)}draw(e){let t=this.picture;if(!t||this.lost)return;this.look(e);for(let o of Zh){let a=t.layers[o];if(this.placed[o]!==a.version){this.placed[o]=a.version;for(let l of this.batches[o]){for(let c of l.drawn)c.visible=a.shown;a.shown&&l.place(a.position,a.orientation,a.hidden)}}this.trails[o].sync(t.trails[o])}for(let o of this.strips)o.sync();for(let{material:o}of this.waters)o.uniforms.time.value=t.time;let[i,s,r]=t.theme.ground;this.renderer.getContext().clearColor(i,s,r,1),this.renderer.setClearColor(Math.round(i*255)<<16|Math.round(s*255)<<8|Math.round(r*255),1),this.renderer.render(this.scene,this.camera)}clear(){for(let e of Zh){for(let t of this.batches[e])t.dispose();this.trails?.[e].dispose(),this.trails?.[e].material.dispose()}for(let e of this.strips)e.dispose();for(let{mesh:e,material:t}of this.waters)e.geometry.dispose(),t.dispose();this.colours?.dispose(),this.batches={bodies:[],ghost:[]},this.strips=[],this.waters=[],this.trails=null,this.scene.clear()}dispose(){this.clear();for(let e of Object.values(this.materials))e.dispose();this.canvas.removeEventListener("webglcontextlost",this.onLost),this.canvas.removeEventListener("webglcontextrestored",this.onRestored),this.renderer.dispose(),this.renderer.forceContextLoss()}};var nP=()=>/[?&#]webgl=off\b/.test(`${location.search}${location.hash}`),pm=null;function iP(){if(pm!==null)return pm;let n=document.createElement("canvas").getContext("webgl2"),e=n?.getExtension("WEBGL_debug_renderer_info"),t=e?String(n.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),pm=/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}function bv(){if(!nP()){let n=document.createElement("canvas"),e=n.getContext("webgl2",{antialias:!iP(),alpha:!1,powerPreference:"high-performance"});if(e)try{return new Kh(n,e)}catch{}}return new Wh(document.createElement("canvas"))}var jh=class{constructor(e,t,i){this.options=i;this.root.className="scene3d",e.append(this.root),this.stage=bv(),this.stage.onChange=()=>this.relabel(),this.webgl=this.stage.webgl,this.element=this.stage.canvas,this.element.tabIndex=0,this.element.setAttribute("role","application"),this.element.setAttribute("aria-roledescription","3D view"),this.element.setAttribute("aria-label",`${i.label}. Arrow keys turn, plus and minus zoom, Home frames all.`),this.over.className="scene3d-over",this.over.setAttribute("aria-hidden","true"),this.note.className="scene3d-note",this.note.setAttribute("role","status"),this.root.append(this.element,this.over,this.note),this.picture=new Nl(t,Nf(this.root),i.bounds),this.stage.show(this.picture),this.state=Ff(this.picture.bounds,4/3),this.controls=new Dc(this.element,this),this.resized.observe(this.root),this.restyled.observe(document.documentElement,{attributes:!0,attributeFilter:["class","style","data-theme"]}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.retheme(),{signal:this.stop.signal})}options;element;webgl;onCamera=null;onFrameAll=null;onGrab=null;onPull=null;onRelease=null;root=document.createElement("div");over=document.createElement("canvas");note=document.createElement("div");stage;controls;picture;state;framed=!1;framing=null;stale=!0;overStale=!0;held=null;stop=new AbortController;resized=new ResizeObserver(()=>this.turned());restyled=new MutationObserver(()=>this.retheme());get camera(){return this.state}set camera(e){this.state=F_(e),this.framed=!0,this.turned()}moveCamera(e){this.camera=e,this.onCamera?.(this.state)}frameOn(e){this.framing=Cc(e),this.turned()}frameAll(){this.framed=!1,this.turned()}reset(){this.frameAll(),this.view(),this.onFrameAll?this.onFrameAll():this.onCamera?.(this.state)}show(e,t,i){this.picture.layers[e].set(t),Number.isFinite(i)&&(this.picture.time=i),this.stale=!0,e==="bodies"&&this.relabel()}relabel(){let e=this.picture.lost(),t=e.length>3?`${e.slice(0,3).join(", ")} and ${e.length-3} more`:e.join(", "),i=this.stage.lost?"the graphics card was lost; waiting for it":e.length>0?`not finite: ${t}`:"";this.note.textContent!==i&&(this.note.textContent=i),this.stale=!0}trails(e,t,i,s){this.picture.setTrail(e,t,i,s),this.stale=!0}arrows(e){this.picture.arrows=e,this.stale=!0}contacts(e,t){this.picture.setContacts(e,t),this.stale=!0}pulls(e){this.picture.pulls=e,this.stale=!0}links(e){this.picture.linksShown=e,this.stale=!0}replaceScene(e){let{linksShown:t}=this.picture;this.picture=new Nl(e,this.picture.theme,this.options.bounds),this.picture.linksShown=t,this.stage.show(this.picture),this.relabel(),this.turned()}retheme(){this.picture.theme=Nf(this.root),this.turned()}view(){let e=Math.max(this.root.clientWidth,1),t=Math.max(this.root.clientHeight,1),i=this.framing??this.picture.bounds;this.framed||(this.state=Ff(i,e/t));let s=Tt(mt(i.max,i.min));return U_(this.state,{width:e,height:t,ratio:Math.min(devicePixelRatio||1,2)},s)}metresPerPixel(){return cs(this.view())}ray(e,t,i){return this.webgl?k_(e,t,i):O_(e,t,i)}grab(e,t){let i=this.picture.layers.bodies;if(!this.onGrab||!i.shown)return!1;let s=this.view(),r=cs(s),o=u=>6*r*(this.webgl?u/s.distance:1),a=G_(this.ray(s,e,t),this.picture.solids,i,o);if(!a||this.picture.scene.body[a.body].locked)return!1;let{body:l,point:c}=a;return this.held=c,this.onGrab({body:l,point:c,anchor:Yt(qi(i.turn(l)),mt(c,i.at(l)))}),!0}pull(e,t){if(!this.held)return;let i=this.view(),{from:s,along:r}=this.ray(i,e,t),o=xt(mt(this.held,s),i.back)/xt(r,i.back);this.onPull?.(je(s,nt(r,o)))}release(){this.held=null,this.onRelease?.()}render(){if(!this.stale)return;this.stale=!1,this.picture.relink();let e=this.view(),{grid:t}=this.picture;this.picture.setEye(e.eye,this.framing??this.picture.bounds),this.picture.grid!==t&&(this.overStale=!0),this.stage.draw(e),this.overStale&&this.drawOver(e)}drawOver(e){this.overStale=!1,[this.over.width,this.over.height]=[this.element.width,Math.round(Of*e.ratio)];let t=this.picture.scene.plane.length>0?this.picture.grid:null,i=this.over.getContext("2d");i&&V_(i,e,this.picture.theme,t)}turned(){this.stale=this.overStale=!0}get size(){return{width:this.element.width,height:this.element.height}}paint(e,t,i){this.stale=!0,this.render(),e.drawImage(this.element,t,i),e.drawImage(this.over,t,i+this.element.height-this.over.height)}png(){let e=document.createElement("canvas");this.stale=!0,this.render(),[e.width,e.height]=[this.element.width,this.element.height];let t=e.getContext("2d");return t&&this.paint(t,0,0),new Promise((i,s)=>e.toBlob(r=>r?i(r):s(new Error("the picture could not be kept")),"image/png"))}dispose(){this.stop.abort(),this.resized.disconnect(),this.restyled.disconnect(),this.controls.dispose(),this.stage.dispose(),this.root.remove(),this.onCamera=this.onFrameAll=this.onGrab=this.onPull=this.onRelease=null}};function Qh(n,e,t){return new jh(n,e,t)}function sP(n,e){let t=n.getContext("2d");[...e].forEach((i,s)=>{s===0&&([n.width,n.height]=[i.width,i.height]),i.width>0&&i.height>0&&t?.drawImage(i,0,0)})}function Sv(n,e,t){let i=document.createElement("canvas");i.className="pane-paper";let s=()=>{e(),queueMicrotask(()=>{t(),sP(i,n.querySelectorAll("canvas")),n.after(i)})},r=()=>i.remove();return addEventListener("beforeprint",s),addEventListener("afterprint",r),()=>{removeEventListener("beforeprint",s),removeEventListener("afterprint",r),r()}}var ed=class{linked=!0;moved=null;scenes=new Set;join(e){return this.moved&&this.linked&&(e.camera=this.moved),this.scenes.add(e),e.onCamera=t=>{if(this.moved=t,this.linked)for(let i of this.scenes)i!==e&&(i.camera=t)},()=>{this.scenes.delete(e)}}};function Mv(n,e){let t=n.position.length/n.time.length/3;return{position:n.position.subarray(3*t*e,3*t*(e+1)),orientation:n.orientation.subarray(4*t*e,4*t*(e+1))}}function rP(n,{bodies:e,ghost:t},i,s,r){if(e.time.length===0){n.show("bodies",null,i),n.trails("bodies",null,0,0),n.show("ghost",null,i);return}let o=As(e.time,i),a=e.time[o];n.show("bodies",Mv(e,o),i);let l=e.position.length/e.time.length/3;n.trails("bodies",r?e.position:null,l,o);let c=t&&t.time.length>0?As(t.time,a):-1,u=s&&t&&c>=0&&Math.abs(t.time[c]-a)<=1e-6*Math.abs(a);n.show("ghost",u?Mv(t,c):null,i)}async function oP(n,e){if(!n)return;let t=document.createElement("a");t.href=URL.createObjectURL(await n.png()),t.download=`${e.replace(/[^\w.-]+/g,"_")}.png`,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e3)}function mm({title:n,scene:e,motions:t,bounds:i,cursor:s,cameras:r,ghost:o,trails:a}){let l=Vt(null),c=Vt(null),u=Vt(null),f=Vt(()=>{});return f.current=()=>{c.current&&rP(c.current,t,s.time,o,a)},Rt(()=>{let d=Qh(l.current,e,{label:`3D picture of ${te(n)}`,...i?{bounds:i}:{}});c.current=d,!d.webgl&&u.current&&(u.current.textContent="No WebGL here: drawn flat, without perspective.");let p=[r.join(d),s.listen(()=>f.current()),So(()=>f.current()),Sv(l.current,()=>f.current(),()=>d.render())],m=requestAnimationFrame(function v(){d.render(),m=requestAnimationFrame(v)});return()=>{cancelAnimationFrame(m);for(let v of p)v();d.dispose(),c.current=null}},[e,i,s,r]),Rt(()=>f.current()),h("figure",{class:"pane",children:[h("figcaption",{children:[h("strong",{children:te(n)})," ",h("span",{class:"note",ref:u})," ",h("button",{type:"button",class:"on-screen",onClick:()=>{oP(c.current,n)},children:"save as PNG"})]}),h("div",{class:"pane-picture",ref:l})]})}function gm(n,e){let{motion:t,ghost:i}=e.trace;return{title:n,block:e,frames:e.frames(t),ghost:i?e.frames(i):null}}function aP({ghost:n,frames:e}){return!n||n.time.length>=e.time.length?"":`It is known at ${on(n.time.length,"time")} and shown at no other. `}function or(n){return[n.engine,n.integrator,n.dt_text].join(" ")}function wv({scene:n,own:e,other:t,choices:i,chosen:s,bounds:r,cursor:o,trouble:a}){let[l,c]=lt(!0),[u,f]=lt(!0),[d,p]=lt(!0),m=He(()=>new ed,[]);m.linked=d;let v=e.block.trace.ghost,_=[["ghost of the truth",l,c,e.ghost===null],["trails",u,f,!1],["cameras linked",d,p,t===null]],g={scene:n,bounds:r,cursor:o,cameras:m,ghost:l,trails:u};return h("section",{"aria-labelledby":"side-heading",children:[h("h3",{id:"side-heading",children:"Side by side"}),h("div",{class:"side-tools on-screen",children:[h("label",{children:["beside it"," ",h("select",{value:s,onChange:y=>wn({other:y.currentTarget.value||"-"}),children:[h("option",{value:"",children:"nothing"}),i.map(y=>h("option",{value:or(y),children:te(or(y))},or(y)))]})]}),_.map(([y,E,M,I])=>h("label",{children:[h("input",{type:"checkbox",checked:E,disabled:I,onChange:()=>M(!E)})," ",y]},y))]}),a?h("p",{class:"note",children:te(a)}):null,h("div",{class:"panes",children:[h(mm,{title:e.title,motions:{bodies:e.frames,ghost:e.ghost},...g},e.title),t?h(mm,{title:t.title,motions:{bodies:t.frames,ghost:t.ghost},...g},t.title):null]}),h("p",{class:"note",children:[v?`The ghost follows ${te([v.follows,v.source].filter(Boolean).join(": "))}. ${aP(e)}`:"This scene has no truth that tells where its bodies are: there is no ghost. ","Shown is the stored frame nearest to the cursor; nothing is drawn between frames."]})]})}var _m=[.001,.01,.1,.25,.5,1,2,5,10,100];function Tv(n){return n>=2&&n<=60?1:_m.reduce((e,t)=>Math.abs(Math.log(t*10/n))<Math.abs(Math.log(e*10/n))?t:e)}function Av(n,e){let[t,i]=lt(!1);return Rt(()=>{if(!t)return;n.running=!0;let r=matchMedia("(prefers-reduced-motion: reduce)").matches?500:0,o=performance.now(),a=requestAnimationFrame(function l(c){c-o>=r&&(n.pin+=(c-o)/1e3*e,o=c),n.pin>=n.whole[1]?i(!1):a=requestAnimationFrame(l)});return()=>{n.running=!1,cancelAnimationFrame(a)}},[t,n,e]),{playing:t,toggle:()=>{!t&&n.pin>=n.whole[1]&&(n.pin=n.whole[0]),i(!t)}}}function xm(n,e,t){let i=As(e,n.pin),s=Math.min(e.length-1,Math.max(0,i+t));n.pin=e[s]??n.pin}var lP='input, select, textarea, button, a, summary, canvas, [role="region"], [role="grid"]';function cP(n,e){bi(()=>{let t=i=>{let s=i.key==="ArrowLeft"?-1:i.key==="ArrowRight"?1:0;s===0||i.altKey||i.ctrlKey||i.metaKey||i.target instanceof Element&&i.target.closest(lP)||(i.preventDefault(),xm(n,e,i.shiftKey?10*s:s))};return addEventListener("keydown",t),()=>removeEventListener("keydown",t)},[n,e])}function uP({cursor:n,divergence:e}){return h("p",{class:"jump",children:[h("button",{type:"button",disabled:!e,onClick:()=>e&&(n.pin=e.time),children:"jump to the first divergence"})," ",e?`${e.what}, at ${De(e.time,6)} s`:"no first violation is recorded, and the engines shown do not part by 1 % of the extent"]})}function Ev({cursor:n,frames:e,divergence:t}){let i=ac(n),[s,r]=lt(()=>Tv(n.whole[1]-n.whole[0])),{playing:o,toggle:a}=Av(n,s);cP(n,e);let l=As(e,i);return h("div",{class:"timeline on-screen",role:"group","aria-label":"Time cursor of all plots and pictures",children:[h("div",{class:"timeline-row",children:[h("button",{type:"button",onClick:a,children:o?"pause":"play"}),h("button",{type:"button",onClick:()=>xm(n,e,-1),children:"\u22121 frame"}),h("button",{type:"button",onClick:()=>xm(n,e,1),children:"+1 frame"}),h("input",{type:"range","aria-label":"time",min:n.whole[0],max:n.whole[1],step:(n.whole[1]-n.whole[0])/1e3,value:i,"aria-valuetext":`${De(i)} s`,onInput:c=>n.pin=Number(c.currentTarget.value)}),h("output",{class:"number",children:[De(i,5)," s of ",De(n.whole[1],5)," s, frame ",l+1," of ",e.length]}),h("label",{children:["speed"," ",h("select",{value:s,onChange:c=>r(Number(c.currentTarget.value)),children:_m.map(c=>h("option",{value:c,children:[c," \xD7"]},c))})]}),h("button",{type:"button",onClick:()=>n.lookCloser(),children:"plots: closer"}),n.window?h("button",{type:"button",onClick:()=>n.window=null,children:"plots: whole time"}):null]}),h(uP,{cursor:n,divergence:t})]})}var hP=[{title:"Energy",names:["energy","kinetic energy"]},{title:"Momentum",names:["momentum"]},{title:"Angular momentum",names:["angular momentum"]}];function Cv(n,e,t,i,s){let r=Float64Array.from(n.floats(e.value)),o=r[0]??0;return{label:i,style:s,time:n.floats(e.time),value:t?r.map(a=>a-o):r}}function dP(n,e,t,i){return e.trace.totals.filter(r=>n.includes(r.name)).flatMap((r,o)=>{let a=`${r.name}${r.component?`, ${r.component}`:""}`,l=f=>f.name===r.name&&f.component===r.component,c=t?.block.trace.totals.find(l),u=[Cv(e,r,i,a,o)];return t&&c&&u.push({...Cv(t.block,c,i,`${t.engine}: ${a}`,o),faint:!0}),u})}function Rv({block:n,other:e,cursor:t}){let[i,s]=lt(!0),r=He(()=>hP.map(({title:o,names:a})=>({title:o,unit:n.trace.totals.find(l=>a.includes(l.name))?.unit??"",curves:dP(a,n,e,i)})),[n,e,i]);return h("section",{"aria-labelledby":"totals-heading",children:[h("h3",{id:"totals-heading",children:"Energy and momenta against time"}),h("label",{class:"on-screen",children:[h("input",{type:"checkbox",checked:i,onChange:()=>s(!i)})," change since the start"]}),n.trace.totals.length===0?h("p",{class:"empty",children:"The trace holds none."}):null,h("div",{class:"total-plots",children:r.filter(({curves:o})=>o.length>0).map(({title:o,unit:a,curves:l})=>{let c=`${i?"\u0394 ":""}${o.toLowerCase()} [${a}]`;return h("figure",{children:[h(Tc,{curves:l,label:Ec(o,l,a),axis:c,log:!1,cursor:t,number:De,height:250}),h("figcaption",{children:h(Ac,{curves:l,cursor:t,log:!1,unit:a,caption:c})})]},o)})}),h("p",{class:"note",children:"Curves are stored in single precision: a change below 6e-8 of the value itself does not show. The verdicts above come from the whole states."})]})}var Ul=new Map,fP=4;function pP(n){let e=Ul.get(n);if(e)return e;let t=jl.of(n);Ul.set(n,t);let[i]=Ul.keys();return Ul.size>fP&&i!==void 0&&Ul.delete(i),t}function td(n){let[e,t]=lt({of:null,value:{state:"absent"}});return Rt(()=>{if(n===null)return;let i=!0,s=r=>i&&t({of:n,value:r});return pP(n).then(r=>s({state:"ready",block:r}),r=>s({state:"broken",why:String(r)})),()=>{i=!1}},[n]),n===null?{state:"absent"}:e.of===n?e.value:{state:"loading"}}function Pv(n,e){let t=i=>i.scenario===e.scenario&&i.engine===e.engine&&i.integrator===e.integrator&&i.dt_text===e.dt;return n.find(t)??null}function mP(n,e){let t=r=>r.startsWith("in-house"),i=r=>t(e.engine)?!t(r.engine):r.engine==="in-house",s=n.filter(r=>r.dt_text===e.dt);return s.find(i)??n.find(i)??s[0]??n[0]??null}function gP(n,e,t,i,s,r){for(let d of[...n.verdicts].sort((p,m)=>ka(m,p))){let p=e.trace.errors.find(m=>m.claim===d.claim)?.first_violation;if(p)return{time:p.time,what:`first violation of '${te(d.claim)}' (${d.status}), step ${p.step}`}}if(!i||!(r>0))return null;let o=Jg(t.frames,i.frames,.01*r);if(!o)return null;let a=s?.scene.body[o.body]?.name??`body ${o.body+1}`,l=Number.isFinite(o.distance)?zn(o.distance,"m"):"a distance that is not finite",c=`${te(a)} of ${te(t.title)} and of ${te(i.title)}`,u=`over 1 % of the scene's extent of ${De(r)} m`,f=`no first violation is recorded; ${c} part by ${l}, ${u}`;return{time:o.time,what:f}}function _P(n,e,t){let i=[t,n.time[n.time.length-1]??0];for(let r of e.trace.errors)i.push(r.first_violation?.time??0);let s=Math.max(...i.filter(Number.isFinite));return[0,s>0?s:1]}function xP(n){let{t:e="0"}=Vn(),t=Vt(e);Rt(()=>{e!==t.current&&(t.current=e,n.pin=Number(e)||0)},[e,n]),Rt(()=>{let i=0,s=n.listen(()=>{clearTimeout(i),i=window.setTimeout(()=>{let r=String(Number(n.pin.toPrecision(6)));r!==t.current&&(t.current=r,wn({t:r==="0"?"":r}))},300)});return()=>{s(),clearTimeout(i)}},[n])}function Iv({index:n,cell:e,view:t,block:i,rows:s}){let{other:r}=Vn(),o=or({scenario:e.scenario,engine:e.engine,integrator:e.integrator,dt_text:e.dt,block:0}),a=He(()=>n.traces.filter(y=>y.scenario===e.scenario&&or(y)!==o),[n,e,o]),l=r==="-"?null:a.find(y=>or(y)===r)??mP(a,e),c=td(l?.block??null),u=He(()=>gm(o,i),[o,i]),f=c.state==="ready"?c.block:null,d=He(()=>f&&l?gm(or(l),f):null,[f,l]),p=He(()=>Yg(u.ghost,[u.frames,d?.frames??null]),[u,d]),m=He(()=>new oc(_P(u.frames,i,t?.duration??0),Number(Ua().t??0)||0),[u,i,t]);xP(m);let v=He(()=>gP(e,i,u,d,t,p?cc(p):0),[e,i,u,d,t,p]),_=He(()=>d&&l?{engine:l.engine,block:d.block}:null,[d,l]),{remarks:g}=i.trace;return h(Ze,{children:[h(Ev,{cursor:m,frames:u.frames.time,divergence:v}),t?h(wv,{scene:t.scene,own:u,other:d,choices:a,chosen:l?or(l):"",bounds:p,cursor:m,trouble:c.state==="broken"?`The other trace cannot be read: ${c.why}`:""}):null,h(A_,{rows:s,block:i,other:_,cursor:m}),h(Rv,{block:i,other:_,cursor:m}),h(C_,{events:i.trace.events,cursor:m}),g.length>0?h("section",{"aria-labelledby":"remarks-heading",children:[h("h3",{id:"remarks-heading",children:"Remarks of the harness"}),h("ul",{children:g.map((y,E)=>h("li",{children:h(Ht,{text:y})},E))})]}):null]})}function yP(n,e){return[...new Set(n.map(e))].join(" | ")}var vP=[["engine",n=>`${n.engine} ${n.version}${n.version_listed?"":" (a version that expected.toml does not list)"}`],["precision",n=>n.precision],["path",n=>n.path],["gyroscopic term",n=>n.gyroscopic],["integrator",n=>n.integrator],["step",n=>`${n.dt_text} s (${De(n.dt,17)} s)`],["sampling",n=>n.sampling],["CPU time",n=>`${Jn(n.cpu_seconds)} for ${n.body_steps} body-steps`],["scenario hash",n=>n.scenario_hash]];function Dv({verdicts:n,view:e}){return h("section",{"aria-labelledby":"run-heading",children:[h("h3",{id:"run-heading",children:"Run"}),h("dl",{class:"facts",children:[vP.map(([t,i])=>h("div",{children:[h("dt",{children:t}),h("dd",{children:h(Ht,{text:yP(n,i)})})]},t)),e?h("div",{children:[h("dt",{children:"scenario"}),h("dd",{children:[De(e.duration)," s, nominal step ",De(e.step,6)," s, ",e.scene.body.length," bodies, tags: ",te(e.tags.join(", ")||"none")]})]}):null]})]})}function Nv({verdicts:n}){let e=Object.entries(Object.assign({},...n.map(i=>i.settings))),t=[...new Set(n.flatMap(i=>i.unforceable))];return h("section",{"aria-labelledby":"settings-heading",children:[h("h3",{id:"settings-heading",children:"Settings forced on the engine"}),e.length===0?h("p",{children:"None: it ran as it is."}):null,h("dl",{class:"facts",children:e.map(([i,s])=>h("div",{children:[h("dt",{children:te(i)}),h("dd",{children:te(s)})]},i))}),h("h3",{children:"Known limits of the engine"}),t.length===0?h("p",{children:"Nothing is known."}):null,h("ul",{children:t.map(i=>h("li",{children:te(i)},i))})]})}var Fv="\u2013";function nd(n,e){return n===null?Fv:zn(n,e==="1"?"":e)}function bP(n){let e=n.body_count-n.bodies.length,t=n.bodies.join(", ")+(e>0?` and ${e} more`:"");return n.body_count===0?"the scene":t}var Lv=[["part",bP],["method",n=>n.method+(n.order>0?`, order ${n.order}`:"")||Fv],["since",n=>nd(n.since,"s")],["until",n=>n.until===null?"the end":nd(n.until,"s")],["times",n=>`${n.count}`],["asked, or cap",n=>nd(n.limit,n.limit_unit)],["reached",n=>nd(n.reached,n.unit)],["in words",n=>n.text]];function Uv({verdicts:n}){let e=n.find(t=>t.diagnostics.length>0)?.diagnostics??[];return e.length===0?null:h("section",{"aria-labelledby":"diagnostics-heading",children:[h("h3",{id:"diagnostics-heading",children:"What the engine says of this run"}),h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Diagnostics of this run",children:h("table",{children:[h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"kind"}),Lv.map(([t])=>h("th",{scope:"col",children:t},t))]})}),h("tbody",{children:e.map((t,i)=>h("tr",{children:[h("th",{scope:"row",children:te(t.kind)}),Lv.map(([s,r])=>h("td",{children:h(Ht,{text:r(t)})},s))]},i))})]})})]})}function kv({verdicts:n}){let e=[...new Set(n.map(t=>t.stderr))].filter(t=>t!=="");return h("section",{"aria-labelledby":"output-heading",children:[h("h3",{id:"output-heading",children:"What the engine wrote to stderr"}),e.length===0?h("p",{children:"Nothing."}):null,e.map((t,i)=>h(wo,{text:t,label:"stderr of the engine"},i))]})}var SP=[];function MP({matrix:n,cell:e}){let t=n.rows.find(i=>i.scenario===e.scenario&&i.dt===e.dt);return h("ul",{class:"neighbours on-screen","aria-label":"Engines of this scenario",children:(t?.cells??[]).flatMap((i,s)=>i?h("li",{children:h("a",{href:Yn(ws(i)),"aria-current":i===e?"page":void 0,children:[te(n.columns[s].label)," ",h("span",{class:`status ${$n[i.worst].tone}`,children:$n[i.worst].glyph}),i.differs?h(Ws,{}):null]})},s):[])})}function wP({cell:n,view:e}){let t=Tn(n.worst)&&n.digits!==null?`, ${ri(n.digits)} digits`:"";return h(Ze,{children:[h("h2",{id:"cell-heading",tabIndex:-1,children:[te(n.scenario)," / ",te(n.engine)," ",h("span",{class:"note",children:te(`${n.integrator}, dt ${n.dt}`)})]}),h("p",{class:"cell-verdict",children:[h(rs,{status:n.worst}),t," by the worst of ",on(n.verdicts.length,"claim"),n.differs?" ":"; as expected.toml says",n.differs?h(Ws,{text:"differs from expected.toml"}):null]}),e?h(Ze,{children:[h("p",{children:h("strong",{children:h(Ht,{text:e.title})})}),h("p",{children:h(Ht,{text:e.story})})]}):h("p",{class:"note",children:"The report does not describe this scenario."})]})}function TP({cell:n}){let e=[...new Set(n.verdicts.map(t=>t.reproduce))];return h("section",{"aria-labelledby":"reproduce-heading",children:[h("h3",{id:"reproduce-heading",children:"To reproduce it"}),e.map(t=>h(rc,{text:t},t))]})}function AP(){wn(gr(Ua().section??""),!0)}function EP(){bi(()=>{let n=e=>{e.key==="Escape"&&!e.defaultPrevented&&AP()};return addEventListener("keydown",n),()=>removeEventListener("keydown",n)},[])}function CP(n,e){let{claims:t}=Vn(),i=He(()=>{if(t!==void 0)return new Set(t.split(",").filter(o=>o!=="-").map(Number));let[r]=sc(n.verdicts.filter(o=>e.has(o.claim)));return new Set(r?[n.verdicts.indexOf(r)]:[])},[t,n,e]);return[i,r=>{let o=new Set(i);o.delete(r)||o.add(r),wn({claims:o.size===0?"-":[...o].sort((a,l)=>a-l).join(",")})}]}function Ov({index:n,matrix:e,cell:t,view:i}){let s=He(()=>Pv(n.traces,t),[n,t]),r=td(s?.block??null),o=r.state==="ready"?r.block.trace.errors:SP,a=He(()=>new Set(o.map(d=>d.claim)),[o]),l=He(()=>Gg(t.verdicts,i,o),[t,i,o]),[c,u]=CP(t,a),f=He(()=>l.filter(d=>c.has(d.index)),[l,c]);return EP(),Rt(()=>{scrollTo(0,0),document.getElementById("cell-heading")?.focus()},[t]),h("article",{class:"cell-page","aria-labelledby":"cell-heading",children:[h("p",{class:"on-screen",children:[h("a",{href:Yn(gr(Ua().section??"")),children:"back to the matrix"})," ",h("kbd",{children:"Escape"})]}),h(MP,{matrix:e,cell:t}),h(wP,{cell:t,view:i}),h(TP,{cell:t}),h(Wg,{rows:l,shown:c,toggle:u}),r.state==="ready"?h(Iv,{index:n,cell:t,view:i,block:r.block,rows:f},s.block):h(RP,{state:r.state,why:r.state==="broken"?r.why:n.omitted_traces,cell:t}),h("div",{class:"columns",children:[h(Dv,{verdicts:t.verdicts,view:i}),h(Nv,{verdicts:t.verdicts})]}),h(Uv,{verdicts:t.verdicts}),h(kv,{verdicts:t.verdicts})]})}function RP({state:n,why:e,cell:t}){if(n==="loading")return h("p",{role:"status",children:"Unpacking the trace\u2026"});let i=n==="broken"?"The trace cannot be read.":"No trace of this run is stored: there are no curves and no pictures.";return h("section",{"aria-label":`Trace of ${te(t.engine)}`,children:h("p",{class:"empty",children:[i," ",te(e)]})})}var Bv="\0",id=class{order=new Map;several=new Map;index(e,t){let i=e+Bv+t,s=this.order.get(i);return s?s.index:(this.order.set(i,{index:this.order.size,first:e,second:t}),this.several.set(e,(this.several.get(e)??0)+1),this.order.size-1)}all(){return[...this.order.values()].map(({first:e,second:t})=>({first:e,second:t,label:this.several.get(e)>1?`${e} ${t}`:e}))}};function PP(n,e){let t=e.status!=="unsupported"&&Gi(e.status)>Gi(n.worst);if((n.worst==="unsupported"||t)&&(n.worst=e.status),Tn(e.status)){let i=is(e.measured,e.allowed);n.digits=n.digits===null?i:Math.min(n.digits,i)}n.differs||=ss(e),n.closedForm||=e.closed_form,n.verdicts.push(e)}function IP(n,e){let t=e.filter((i,s)=>n.cells[s]?.worst==="pass").map(({label:i})=>i);for(let i of n.cells)i?.worst==="unsupported"&&(i.passedBy=t)}function LP(n){let e=new Map,t=new Map,i=new Set;for(let s of n){if(s.integrator==="")continue;e.has(s.engine)||e.set(s.engine,s.integrator);let r=[s.engine,s.scenario,s.dt_text].join(Bv);t.has(r)||t.set(r,s.integrator),t.get(r)!==s.integrator&&i.add(s.engine)}return s=>i.has(s.engine)?s.integrator||(e.get(s.engine)??""):""}function sd(n){let e=new id,t=new id,i=LP(n),s=[];for(let a of n){let l=s[e.index(a.scenario,a.dt_text)]??=[],c=t.index(a.engine,i(a)),{scenario:u,engine:f,integrator:d,dt_text:p,status:m}=a;l[c]??={scenario:u,engine:f,integrator:d,dt:p,verdicts:[],worst:m,digits:null,differs:!1,closedForm:!1,passedBy:[]},PP(l[c],a)}let r=t.all().map(({first:a,second:l,label:c})=>({engine:a,integrator:l,label:c})),o=e.all().map(({first:a,second:l,label:c},u)=>({scenario:a,dt:l,label:c,cells:r.map((f,d)=>s[u]?.[d]??null)}));for(let a of o)IP(a,r);return{columns:r,rows:o}}function Vv(n,e){let t=n.rows.flatMap(i=>i.cells[e]??[]);return{run:t.filter(i=>i.worst!=="unsupported").length,asked:t.length}}function zv(n,e){let t=n.rows.find(s=>s.scenario===e.scenario&&s.dt===e.dt),i=s=>s.engine===e.engine&&s.integrator===e.integrator;return t?.cells.find(s=>s?.verdicts.some(i))??null}function ym(n){let e=0,t=-1,i=100;for(let s of n.cells)s&&(s.differs&&(e=1),t=Math.max(t,Gi(s.passedBy.length>0?"fail":s.worst)),i=Math.min(i,s.digits??100));return[e,t,-i]}function va(n){let e=n.toLowerCase();return t=>DP(e,t.toLowerCase())}function DP(n,e){let[t,i]=[0,0],[s,r]=[-1,0];for(;i<e.length;)if(n[t]==="*")s=t++,r=i;else if(t<n.length&&(n[t]==="?"||n[t]===e[i]))++t,++i;else if(s>=0)t=s+1,i=++r;else return!1;for(;n[t]==="*";)++t;return t===n.length}var NP={"<":(n,e)=>n<e,"<=":(n,e)=>n<=e,">":(n,e)=>n>e,">=":(n,e)=>n>=e,"=":(n,e)=>n===e};function FP(n){switch(n){case"none":return e=>e===null;case"pass":return e=>e?.worst==="pass";case"differs":return e=>e?.differs===!0;case"expected":return e=>e?.differs===!1;default:return e=>e!==null&&e.verdicts.some(t=>t.status===n)}}function Gv(n,e,t){let i=va(n),s=e.flatMap((r,o)=>i(r.engine)||i(r.label)?[o]:[]);return r=>s.some(o=>t(r.cells[o]??null))}function UP(n,e,t){let i=va(e);switch(n){case"scenario":return s=>i(s.scenario);case"tag":return s=>t.get(s.scenario)?.tags.some(i)??!1;case"claim":return s=>s.cells.some(r=>r?.verdicts.some(o=>i(o.claim)||i(o.observable)))}}function kP(n,e){let t=/[*?]/.test(n)?va(`*${n}*`):i=>i.toLowerCase().includes(n);return i=>t(i.scenario)||t(e.get(i.scenario)?.title??"")}function vm(n,e,t){let i=s=>vm(s,e,t);switch(n.kind){case"all":return()=>!0;case"and":{let s=n.parts.map(i);return r=>s.every(o=>o(r))}case"or":{let s=n.parts.map(i);return r=>s.some(o=>o(r))}case"not":{let s=i(n.part);return r=>!s(r)}case"word":return kP(n.text,t);case"field":return UP(n.field,n.glob,t);case"status":return Gv(n.engine,e,FP(n.status));case"digits":{let s=NP[n.relation];return Gv(n.engine,e,r=>r?.digits!=null&&s(r.digits,n.value))}}}function Hv(n,e){let t=e.map(()=>n.length===0||n[0].startsWith("-"));for(let i of n){let s=i.startsWith("-"),r=va(s?i.slice(1):i);e.forEach((o,a)=>{(r(o.engine)||r(o.label))&&(t[a]=!s)})}return t}var hi=class extends Error{constructor(t,i,s){super(t);this.at=i;this.length=s}at;length},bm=["pass","low-quality","fail","undecided","unsupported","crash","timeout","non-finite","protocol","differs","expected","none"],OP=["scenario","tag","claim"];function BP(n){let e=[],t=0;for(;t<n.length;){let i=n[t];if(/\s/.test(i))++t;else if(i==="("||i===")")e.push({text:i,at:t++,quoted:!1});else{let s=VP(n,t);e.push(s),t+=s.length}}return e}function VP(n,e){let t=e,i="",s=-1;for(;t<n.length;++t){let r=n[t];if(r==='"')s=s<0?t:-1;else{if(s<0&&/[\s()]/.test(r))break;i+=r}}if(s>=0)throw new hi("this quote is never closed",s,n.length-s);return{text:i,at:e,quoted:n[e]==='"',length:t-e}}function zP(n,e){let t=Array.from({length:e.length+1},(i,s)=>s);for(let i=1;i<=n.length;++i){let s=[i];for(let r=1;r<=e.length;++r)s.push(Math.min(s[r-1]+1,t[r]+1,t[r-1]+ +(n[i-1]!==e[r-1])));t=s}return t[e.length]}var Wv=100,Sm=class{constructor(e,t){this.list=e;this.end=t}list;end;next=0;depth=0;columns=[];whole(){if(this.list.length===0)return{kind:"all"};let e=this.either(),t=this.list[this.next];if(t)throw new hi("this closes nothing",t.at,1);return e}is(e){let t=this.list[this.next];return t!==void 0&&!t.quoted&&t.text.toLowerCase()===e}take(e){return this.is(e)?(++this.next,!0):!1}either(){let e=this.list[this.next],t=this.columns.length,i=[this.both()];for(;this.is("or");){if(this.columns.length>t)throw $v(e);this.nested(()=>(++this.next,i.push(this.both())))}return i.length===1?i[0]:{kind:"or",parts:i}}both(){let e=[this.single()];for(;this.next<this.list.length&&!this.is("or")&&!this.is(")");)this.take("and"),e.push(this.single());let t=e.filter(({kind:i})=>i!=="all");return t.length>1?{kind:"and",parts:t}:t[0]??{kind:"all"}}single(){let e=this.list[this.next];if(!e)throw new hi("a term is missing here",this.end,1);if(this.take("not"))return{kind:"not",part:this.nested(()=>this.single())};if(this.take("(")){let t=this.nested(()=>this.either());if(!this.take(")"))throw new hi("this parenthesis is never closed",e.at,1);return t}if(this.is(")")||this.is("and")||this.is("or"))throw new hi(`a term is missing before '${e.text}'`,e.at,e.text.length);return++this.next,this.term(e)}nested(e){if(++this.depth>Wv)throw new hi(`nested deeper than ${Wv}`,this.list[this.next-1].at,1);let t=e();return--this.depth,t}term(e){let t=e.text.toLowerCase();if(e.quoted)return{kind:"word",text:t};let i=/^(?:(.*):)?digits(<=|>=|<|>|=)(.*)$/.exec(t);if(i)return this.digits(e,i[1]??"*",i[2],i[3]);if(t.endsWith(":"))throw new hi(`nothing stands after '${t}'`,e.at,t.length);if(t.startsWith("columns:"))return this.show(e,t.slice(8));let s=OP.find(l=>t.startsWith(`${l}:`));if(s)return{kind:"field",field:s,glob:t.slice(s.length+1)};let r=t.lastIndexOf(":");if(r<0)return{kind:"word",text:t};let o=t.slice(0,r),a=t.slice(r+1);if(o==="")throw new hi("an engine is missing before the colon",e.at,t.length);if(!bm.includes(a))throw new hi(GP(a),e.at+r+1,a.length);return{kind:"status",engine:o==="any"?"*":o,status:a}}digits(e,t,i,s){let r=Number(s);if(s===""||!Number.isFinite(r)){let o=e.at+e.text.length-s.length;throw new hi(`a number must follow, not '${s}'`,o,Math.max(1,s.length))}return{kind:"digits",engine:t==="any"?"*":t,relation:i,value:r}}show(e,t){if(this.depth>0)throw $v(e);return this.columns.push(...t.split(",").filter(i=>i!=="")),{kind:"all"}}};function $v(n){let e="columns: says what is shown; it cannot stand within 'or', 'not' or parentheses";return new hi(e,n.at,n.text.length)}function GP(n){let e=bm.filter(i=>zP(i,n)<=2)[0],t=e?`did you mean '${e}'?`:`there are ${bm.join(", ")}`;return`no status is called '${n}': ${t}`}function Xv(n){let e=new Sm(BP(n),n.length);return{query:e.whole(),columns:e.columns}}function HP(n){let e=/"[^"]*"|(^|\s)columns:("[^"]*"|[^\s()"])*/gi;return n.replace(e,t=>t.startsWith('"')?t:"").trim()}function qv(n,e){return(e.filter(i=>i.engine===n.engine).length>1?n.label:n.engine).replace(/[\s()",]/g,"?")}function Yv(n,e,t){let i=HP(n);if(t.every(Boolean))return i;let s=e.filter((a,l)=>!t[l]),r=e.filter((a,l)=>t[l]),o=s.length<r.length||r.length===0?s.map(a=>`-${qv(a,e)}`):r.map(a=>qv(a,e));return`${i} columns:${o.join(",")}`.trim()}var WP=[["*:differs","some engine differs from expected.toml"],["bullet:fail and ode:pass","one fails where another passes"],["any:crash or any:timeout","any is short for *"],["bullet*:digits<-2","some Bullet misses a tolerance by more than two digits"],["digits<0 not in-house:digits<0","somebody fails, the in-house engine does not"],["tag:top (claim:energy* or claim:*momentum*)","tags of the scenario, claims or observables; * and ? in all names"],["scenario:heavy_* columns:ode*,bullet","rows by name; only these columns (columns:-ode* leaves out)"],["columns:-in-house*","without the in-house engine"],['"not a spring"',"plain or quoted words are looked for in names and titles"]];function $P({query:n,fault:e}){let t=" ".repeat(e.at)+"^".repeat(Math.max(1,e.length));return h("div",{class:"query-fault",role:"alert",children:[h("pre",{"aria-hidden":"true",children:`${te(n)}
${t}`}),h("p",{children:["Character ",e.at+1,": ",te(e.message),". All rows are shown."]})]})}function XP({onPick:n}){return h("details",{class:"query-help",children:[h("summary",{children:"How to ask"}),h("p",{children:["Terms side by side must all hold; ",h("code",{children:"or"}),", ",h("code",{children:"not"})," and parentheses do as they say."," ",h("code",{children:"ENGINE:STATUS"})," with pass (all claims), low-quality, fail, undecided, unsupported, crash, timeout, non-finite, protocol (some claim), differs, expected, none (not run);"," ",h("code",{children:"ENGINE:digits<X"})," ","with < <= > >= =. An engine means all its columns, shown or not."]}),h("ul",{children:WP.map(([e,t])=>h("li",{children:[h("button",{type:"button",onClick:()=>n(e),children:h("code",{children:e})})," ",t]},e))})]})}function Jv({input:n,fault:e,onQuery:t}){let i=Vn().q??"";return h("div",{class:"filter",role:"search",children:[h("label",{children:["Filter ",h("kbd",{children:"/"})," ",h("input",{ref:n,type:"search",value:i,spellcheck:!1,autocomplete:"off","aria-invalid":e!==null,onInput:s=>t(s.currentTarget.value),placeholder:"bullet:fail and ode:pass"})]}),e?h($P,{query:i,fault:e}):null,h(XP,{onPick:t})]})}var qP={ArrowUp:(n,e)=>[n-1,e],ArrowDown:(n,e)=>[n+1,e],ArrowLeft:(n,e)=>[n,e-1],ArrowRight:(n,e)=>[n,e+1],PageUp:(n,e)=>[n-10,e],PageDown:(n,e)=>[n+10,e],Home:n=>[n,0],End:(n,e,t,i)=>[n,i-1]};function rd(n,e){return Math.min(e-1,Math.max(0,n))}function Zv(n,e,t){let i=Vt(null),s=Vt([0,0]),r=(o,a)=>{let l=(u,f)=>i.current?.querySelector(`[data-row='${u}'][data-column='${f}']`)??null,c=l(o,a);return c?(l(...s.current)?.setAttribute("tabindex","-1"),c.setAttribute("tabindex","0"),s.current=[o,a],c):null};return bi(()=>{i.current?.querySelectorAll('[data-row][tabindex="0"]').forEach(o=>o.setAttribute("tabindex","-1")),r(rd(s.current[0],n),rd(s.current[1],e))}),bi(()=>{let o=i.current;if(!o)return;let a=c=>{let u=qP[c.key];if(!u||!(c.target instanceof HTMLElement)||c.target.dataset.row===void 0||c.altKey||c.metaKey||c.shiftKey)return;let[f,d]=u(...s.current,n,e);c.ctrlKey&&(f=c.key==="Home"?0:c.key==="End"?n-1:f),f=rd(f,n),d=rd(d,e),c.preventDefault();let p=r(f,d);p?p.focus():t()},l=c=>{let{row:u,column:f}=c.target instanceof HTMLElement?c.target.dataset:{};u!==void 0&&f!==void 0&&r(Number(u),Number(f))};return o.addEventListener("keydown",a),o.addEventListener("focusin",l),()=>{o.removeEventListener("keydown",a),o.removeEventListener("focusin",l)}},[n,e,t]),i}function Kv(n){return class extends bo{shouldComponentUpdate(t){return Object.keys(t).some(s=>t[s]!==this.props[s])}render(){return ig(n,this.props)}}}var jv=200;function YP({cell:n,row:e,column:t}){let{glyph:i}=$n[n.worst],s=Tn(n.worst)&&n.digits!==null?` ${ri(n.digits)}`:"",r=te(`${n.scenario}, ${n.engine}`),o=n.passedBy.length>0?" avoidable":"",a=n.closedForm?" =":"";return h("a",{href:Yn(ws(n)),class:"cell",tabIndex:-1,"data-row":e,"data-column":t,"aria-label":`${r}: ${Dg(n.worst,n.digits,n.differs)}${n.closedForm?", closed form":""}${o}`,children:[i+s+a+o,n.differs?h(Ws,{}):null]})}function JP(n){return`${n.passedBy.length>0?"avoidable":$n[n.worst].tone}${n.differs?" has-differs":""}`}function ZP({row:n,column:e}){return h("span",{class:"cell none",tabIndex:-1,"data-row":n,"data-column":e,children:h("span",{class:"unseen",children:"not run"})})}function KP(n){return n.split(/(?<=[/=-])/).flatMap((e,t)=>t===0?[e]:[h("wbr",{},t),e])}var jP=Kv(({row:n,index:e,title:t,shown:i})=>h("tr",{"aria-rowindex":e+2,children:[h("th",{scope:"row",children:[h("span",{class:"name",children:te(n.label)}),t&&t!==n.label?h("span",{class:"title",children:te(t)}):null]}),i.map((s,r)=>{let o=n.cells[s];return h("td",{class:o?JP(o):void 0,children:o?h(YP,{cell:o,row:e,column:r}):h(ZP,{row:e,column:r})},s)})]}));function Qv({columns:n,shown:e,rows:t,titles:i,version:s}){let[r,o]=lt(jv),a=Vt(null),l=Ag(()=>o(f=>f+jv),[]),c=Zv(t.length,e.length,l),u=t.length>r;return Rt(()=>{let f=()=>o(1/0);return addEventListener("beforeprint",f),()=>removeEventListener("beforeprint",f)},[]),Rt(()=>{if(!u||!a.current)return;let f=new IntersectionObserver(d=>d.some(p=>p.isIntersecting)&&l(),{rootMargin:"600px"});return f.observe(a.current),()=>f.disconnect()},[u,r]),h("div",{class:"matrix-scroll",role:"region","aria-label":"Matrix of scenarios and engines",children:[h("table",{class:"matrix",ref:c,role:"grid","aria-rowcount":t.length+1,"aria-readonly":"true",children:[h("caption",{class:"unseen",children:"Scenarios and engines; arrow keys move, Enter opens a cell, Escape comes back"}),h("thead",{children:h("tr",{"aria-rowindex":1,children:[h("th",{scope:"col",children:"scenario"}),e.map(f=>h("th",{scope:"col",children:KP(te(n[f].label))},f))]})}),h("tbody",{children:t.slice(0,r).map((f,d)=>h(jP,{row:f,index:d,title:i.get(f.scenario)??"",shown:e,version:s},`${f.scenario}\0${f.dt}`))})]}),u?h("div",{ref:a,class:"matrix-end",children:[t.length-r," more rows"," ",h("button",{type:"button",onClick:()=>o(1/0),children:"draw all"})]}):null]})}var QP={query:{kind:"all"},columns:[]};function e2(n){try{return{parsed:Xv(n),fault:null}}catch(e){if(e instanceof hi)return{parsed:QP,fault:e};throw e}}function t2(n,e){let[t,i]=[ym(n),ym(e)];return i[0]-t[0]||i[1]-t[1]||i[2]-t[2]}var eb={"":{label:"as run",compare:null},worst:{label:"worst first",compare:t2},name:{label:"by name",compare:(n,e)=>n.label.localeCompare(e.label,"en")}};function n2({columns:n,shown:e,query:t}){let i=s=>wn({q:Yv(t,n,e.map((r,o)=>o===s?!r:r))});return h("details",{class:"column-choice",children:[h("summary",{children:["Columns: ",e.filter(Boolean).length," of ",n.length]}),h("fieldset",{children:[h("legend",{class:"unseen",children:"Columns to show"}),n.map((s,r)=>h("label",{children:[h("input",{type:"checkbox",checked:e[r],onChange:()=>i(r)})," ",te(s.label)]},s.label))]})]})}function i2({rows:n}){let e=new Set(n.flatMap(t=>t.cells.map(i=>i?.worst)));return h("p",{class:"legend",children:[jd.filter(t=>e.has(t)).map(t=>h("span",{children:[h("span",{class:`status ${$n[t].tone}`,children:$n[t].glyph})," ",$n[t].meaning,";"," "]},t)),n.some(t=>t.cells.some(i=>i&&i.passedBy.length>0))?h("span",{children:[h("span",{class:"status avoidable",children:[$n.unsupported.glyph," avoidable"]})," refused, though another engine passes;"," "]}):null,h("span",{children:[h("span",{class:"number",children:"+1.0"})," log10(allowed / measured) of the worst claim: + is better than allowed, \u2212 is worse;"," "]}),n.some(t=>t.cells.some(i=>i?.closedForm))?h("span",{children:"= no steps: the engine has the motion in closed form; "}):null,h("span",{children:[h(Ws,{})," differs from expected.toml"]})]})}function tb({matrix:n,views:e}){let{q:t="",sort:i="",section:s=""}=Vn(),r=Vt(null),{parsed:o,fault:a}=He(()=>e2(t),[t]),l=He(()=>new Map([...e].map(([d,p])=>[d,p.title])),[e]),c=He(()=>Hv(o.columns,n.columns),[o,n]),u=He(()=>c.flatMap((d,p)=>d?[p]:[]),[c]),f=He(()=>{let d=n.rows.filter(vm(o.query,n.columns,e)),p=eb[i]?.compare;return p?d.sort(p):d},[o,n,e,i]);return bi(()=>{let d=p=>{let m=p.target instanceof HTMLInputElement||p.target instanceof HTMLSelectElement;p.key!=="/"||m||p.ctrlKey||p.metaKey||!r.current?.offsetParent||(p.preventDefault(),r.current.select())};return addEventListener("keydown",d),()=>removeEventListener("keydown",d)},[]),h("section",{class:"matrix-section","aria-labelledby":"matrix-heading",children:[h("h2",{id:"matrix-heading",children:"Scenarios and engines"}),h("div",{class:"matrix-tools",children:[h(Jv,{input:r,fault:a,onQuery:d=>wn({q:d})}),h("label",{class:"sort",children:["Order"," ",h("select",{value:i,onChange:d=>wn({sort:d.currentTarget.value}),children:Object.entries(eb).map(([d,{label:p}])=>h("option",{value:d,children:p},d))})]}),h(n2,{columns:n.columns,shown:c,query:t})]}),h("p",{class:"count",role:"status",children:[f.length," of ",n.rows.length," rows, ",u.length," of ",n.columns.length," columns",f.length===0?": nothing answers the filter":""]}),h(Qv,{columns:n.columns,shown:u,rows:f,titles:l,version:`${t} ${i} ${s}`}),h(i2,{rows:n.rows})]})}var Mm={status:"another status",error:"error moved by more than 10 %",new:"new",gone:"gone",scenario:"the scenario itself changed, not compared"};function nb(n){let e=new Map,t=new Map;for(let i of n){let s=[i.scenario,i.engine,i.integrator,i.dt_text,i.claim].join("\0"),r=e.get(s)??0;e.set(s,r+1),t.set(`${s}\0${r}`,i)}return t}function s2(n,e){if(!Tn(n.status)||!Tn(e.status))return null;let[t,i]=[e.measured??1/0,n.measured??1/0];return t===i||Math.abs(i-t)<=.1*Math.abs(t)?null:t===0||i===0?i>t?99:-99:Math.log10(i/t)}function r2(n,e){if(!e)return{kind:"new",verdict:n,before:null,weight:0};if(n.scenario_hash!==e.scenario_hash)return{kind:"scenario",verdict:n,before:e,weight:0};if(n.status!==e.status){let i=is(e.measured,e.allowed)-is(n.measured,n.allowed);return{kind:"status",verdict:n,before:e,weight:1e3*(Gi(n.status)-Gi(e.status))+i}}let t=s2(n,e);return t===null?null:{kind:"error",verdict:n,before:e,weight:t}}var ib=["status","error","gone","new","scenario"];function sb(n,e){let t=nb(e),i=[];for(let[s,r]of nb(n)){let o=r2(r,t.get(s));o&&i.push(o),t.delete(s)}for(let s of t.values())i.push({kind:"gone",verdict:s,before:s,weight:0});return i.sort((s,r)=>ib.indexOf(s.kind)-ib.indexOf(r.kind)||r.weight-s.weight)}function o2(n){let e=new Map;for(let i of n)e.set(i.status,(e.get(i.status)??0)+1);return[...e].sort(([i],[s])=>Gi(s)-Gi(i)).map(([i,s])=>`${s} ${i}`).join(", ")}function wm(n){let e=n.filter(ss),t=n.filter(o=>!ss(o)&&o.status==="undecided").length,i=n.filter(o=>!ss(o)&&o.status!=="pass"&&o.status!=="undecided"),s=n.length-e.length-i.length-t,r=(o,a)=>a.length>0?`${o} (${o2(a)})`:o;return{total:n.length,differ:e,differText:r(`${e.length} ${e.length===1?"differs":"differ"}`,e),expectedText:r(`${i.length} as expected`,i)+(t>0?`, ${t} undecided`:""),passText:`${s} pass`}}function od(n){let e=[],t=new Set([n.provenance.tolerance_scale,...n.verdicts.map(s=>s.tolerance_scale)]);t.delete(1),t.size>0&&e.push(`All tolerances are multiplied by ${[...t].join(", ")}: the verdicts are not those of the stated tolerances.`);let i=new Map;for(let s of n.verdicts)if(!s.version_listed){let r=`${s.engine} ${s.version}`;i.set(r,(i.get(r)??0)+1)}for(let[s,r]of i)e.push(`expected.toml does not list ${s}: ${on(r,"verdict")} ${r===1?"is":"are"} compared with the expectations for other versions.`);return e}function Tm({verdict:n}){let e={scenario:n.scenario,engine:n.engine,integrator:n.integrator,dt:n.dt_text};return h("a",{href:Yn(ws(e)),children:[te(n.scenario)," / ",te(n.engine)]})}function a2(n){if(!Tn(n.status))return n.first_bad_step===null?"":`not finite from step ${n.first_bad_step}`;let e=ri(is(n.measured,n.allowed));return`${ic(n)} of ${zn(n.allowed,n.unit)}, ${e} digits`}function l2(n){let e=new Map;return n.forEach((t,i)=>{let s=Tn(t.status)||t.status==="non-finite",r=[t.scenario,t.engine,t.integrator,t.dt_text,t.status,t.expected,t.detail,s?i:""].join("\0"),o=e.get(r);o?o.push(t):e.set(r,[t])}),[...e.values()]}function c2({group:n}){let e=n[0];return h("tr",{children:[h("th",{scope:"row",children:h(Tm,{verdict:e})}),h("td",{children:[n.length>1?h("strong",{children:[n.length," claims: "]}):"",te(n.map(({claim:t})=>t).join("; "))]}),h("td",{children:h(rs,{status:e.status})}),h("td",{children:e.expected}),h("td",{class:"number",children:a2(e)}),h("td",{children:h(Ht,{text:e.detail})})]})}function rb({verdicts:n,caption:e}){let t=He(()=>l2(n),[n]),{list:i,button:s}=Xi(t);return h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":e,children:[h("table",{children:[h("caption",{children:e}),h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"cell"}),h("th",{scope:"col",children:"claim"}),h("th",{scope:"col",children:"status"}),h("th",{scope:"col",children:"expected"}),h("th",{scope:"col",children:"measured of allowed"}),h("th",{scope:"col",children:"detail"})]})}),h("tbody",{children:i.map((r,o)=>h(c2,{group:r},o))})]}),s]})}function u2({of:n}){let e=n.differ.length>0?"differs":"agrees";return h("p",{class:"verdict-line",children:[on(n.total,"verdict"),": ",h("strong",{class:e,children:n.differText}),","," ",`${n.expectedText}, ${n.passText}`]})}function h2({kind:n,verdict:e,before:t,weight:i}){if(n!=="error"||!t)return"";let s=i>0?`${ri(-i)} digits: worse`:`${ri(-i)} digits: better`;return`${zn(t.measured,t.unit)} to ${zn(e.measured,e.unit)}, ${s}`}function d2({change:n}){let{kind:e,verdict:t,before:i}=n;return h("tr",{children:[h("th",{scope:"row",children:e==="gone"?`${te(t.scenario)} / ${te(t.engine)}`:h(Tm,{verdict:t})}),h("td",{children:te(t.claim)}),h("td",{children:Mm[e]}),h("td",{children:i?h(rs,{status:i.status}):""}),h("td",{children:e==="gone"?"":h(rs,{status:t.status})}),h("td",{class:"number",children:h2(n)})]})}function f2(n){return`${n.cylon} (${n.revision}) of ${n.date}`}function p2({list:n,baseline:e,scale:t}){let{list:i,button:s}=Xi(n),r=Object.entries(Mm).map(([o,a])=>[n.filter(l=>l.kind===o).length,a]).filter(([o])=>o>0).map(([o,a])=>`${o} ${a}`).join(", ");return h("section",{"aria-labelledby":"changes-heading",children:[h("h2",{id:"changes-heading",children:["Since the baseline, ",te(f2(e))]}),h("p",{children:n.length===0?"No status changed, no error moved by more than 10 %.":`${r}.`}),e.tolerance_scale===t?null:h("p",{class:"warnings",children:[h("strong",{children:"Warning:"})," the tolerances of the baseline were multiplied by"," ",e.tolerance_scale,", those of this run by ",t,": statuses of one are not those of the other."]}),n.length>0?h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Changes since the baseline",children:h("table",{children:[h("thead",{children:h("tr",{children:["cell","claim","change","before","now","error"].map(o=>h("th",{scope:"col",children:o},o))})}),h("tbody",{children:i.map((o,a)=>h(d2,{change:o},a))})]})}):null,s]})}function m2({matrix:n}){let e=n.columns.map(({label:s},r)=>({label:s,...Vv(n,r)})),t=e.every(({run:s})=>s===n.rows.length),i=n.rows.flatMap(s=>s.cells.filter(r=>r&&r.passedBy.length>0));return h(Ze,{children:[h("p",{class:"supported",children:["Scenes supported:"," ",t?`all ${n.rows.length} by ${e.length===1?"the engine":`each of ${e.length} engines`}`:e.map(({label:s,run:r,asked:o})=>`${te(s)} ${r} of ${o}`).join(", "),"."]}),i.length>0?h("details",{class:"supported",children:[h("summary",{children:[h("strong",{children:on(i.length,"refusal")})," that another engine shows to be avoidable"]}),h("ul",{children:i.map((s,r)=>h("li",{children:[h("a",{href:Yn(ws(s)),children:[te(s.engine),": ",te(s.scenario)]}),", which ",te(s.passedBy.join(", "))," ",s.passedBy.length===1?"passes":"pass"]},r))})]}):null]})}function ob({index:n,matrix:e}){let t=He(()=>wm(n.results.verdicts),[n]),i=He(()=>od(n.results),[n]);return h(Ze,{children:[t.total>0?h(u2,{of:t}):h("p",{class:"verdict-line",children:"No verdicts: cylon run --json FILE makes them."}),t.total>0?h(m2,{matrix:e}):null,i.length>0?h("ul",{class:"warnings","aria-label":"Warnings",children:i.map(s=>h("li",{children:[h("strong",{children:"Warning:"})," ",te(s)]},s))}):null]})}function ab({index:n}){let e=He(()=>sc(wm(n.results.verdicts).differ),[n]),t=He(()=>n.baseline?sb(n.results.verdicts,n.baseline.verdicts):[],[n]);return h(Ze,{children:[e.length>0?h("section",{"aria-labelledby":"differ-heading",children:[h("h2",{id:"differ-heading",children:"Not as expected.toml says"}),h(rb,{verdicts:e,caption:`${on(e.length,"verdict")}, worst first`})]}):null,n.baseline?h(p2,{list:t,baseline:n.baseline.provenance,scale:n.results.provenance.tolerance_scale}):null]})}function g2({of:n}){return n.detail||n.measured.length===0?h(wo,{text:n.detail,label:"What the engine said"}):h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":`Error of ${te(n.name)} at each step`,children:h("table",{children:[h("caption",{children:["Error at each step; allowed ",De(n.allowed)," ",te(n.unit)]}),h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"step [s]"}),h("th",{scope:"col",children:["error [",te(n.unit),"]"]})]})}),h("tbody",{children:n.measured.map(({dt:e,error:t})=>h("tr",{children:[h("td",{class:"number",children:De(e)}),h("td",{class:"number",children:De(t)})]},e))})]})})}function _2({of:n}){return h("article",{"aria-label":te(n.name),children:[h("h3",{children:[te(n.engine)," ",te(n.version),": ",te(n.signature)]}),h("p",{children:["What should happen: ",h(Ht,{text:n.says}),". ",n.reason," Seen in ",n.hits," ",n.hits===1?"scene":"scenes","; first in ",te(n.found_in),"."]}),h(g2,{of:n}),n.opinions.length>0?h("p",{children:["Other engines: ",n.opinions.map(e=>`${te(e.engine)}: ${te(e.says)}`).join("; "),"."]}):null,h("details",{children:[h("summary",{children:"The least scene"}),h(wo,{text:`${n.command}

${n.scenario}`,label:`Scene of ${te(n.name)}`})]}),n.program?h("details",{children:[h("summary",{children:["A program that shows it without Cylon; it prints ",De(n.program.prints)," ",te(n.program.unit)]}),h(wo,{text:`${n.program.command}

${n.program.text}`,label:`Program of ${te(n.name)}`})]}):h("p",{class:"note",children:["There is no program against the engine's own API: ",h(Ht,{text:n.no_program}),"."]})]})}function lb({index:n}){return h("section",{children:[h("h2",{children:"Faults that were found"}),n.hunts.flatMap((e,t)=>e.cards.map(i=>h(_2,{of:i},`${t} ${i.name}`)))]})}var cb=340,ad=110,Oi={left:66,right:10,top:10,bottom:20};function x2(n){let e=Math.min(...n),t=Math.max(...n),i=(e+t)/2,s=Math.max(.58*(t-e),.05*Math.abs(i))||1;return[i-s,i+s]}function ub({of:n}){let{points:e}=n,t=e.flatMap((v,_)=>typeof v.value=="number"&&Number.isFinite(v.value)?[{i:_,value:v.value}]:[]);if(t.length===0)return h("p",{class:"note",children:"no finite values"});let i=t.map(v=>v.value),[s,r]=x2(n.scale==="ratio"?[...i,1]:i),[o,a]=[ad-Oi.bottom,cb-Oi.right],l=v=>Oi.left+(e.length>1?v/(e.length-1)*(a-Oi.left):(a-Oi.left)/2),c=v=>o-(v-s)/(r-s)*(o-Oi.top),u=Math.min(...i),f=Math.max(...i),d=De(i[i.length-1]),p=`least ${De(u)}, greatest ${De(f)}, last ${d} ${n.unit}`,m=`${e.length} runs, ${p}; ${n.changes.length} change points`;return h("svg",{class:"series-plot",width:cb,height:ad,role:"img","aria-label":te(m),children:[[Oi.top,o].map((v,_)=>h("text",{x:Oi.left-5,y:v+4,"text-anchor":"end",children:De(_===0?r:s,3)},_)),h("line",{class:"frame",x1:Oi.left,x2:a,y1:o,y2:o}),n.scale==="ratio"?h("line",{class:"anchor",x1:Oi.left,x2:a,y1:c(1),y2:c(1)}):null,n.changes.map(v=>h("g",{class:`change ${v.state}`,children:[h("line",{x1:l(v.index),x2:l(v.index),y1:Oi.top,y2:o}),h("path",{d:To(4,l(v.index),Oi.top,5)})]},v.id)),h("polyline",{points:t.map(v=>`${l(v.i).toFixed(1)},${c(v.value).toFixed(1)}`).join(" ")}),e.length<=60?t.map(v=>h("circle",{cx:l(v.i),cy:c(v.value),r:"2.5"},v.i)):null,h("text",{x:Oi.left,y:ad-5,children:["run ",e[0].run]}),h("text",{x:a,y:ad-5,"text-anchor":"end",children:["run ",e[e.length-1].run]})]})}var Am=24;function y2({change:n}){return h("li",{children:[h("strong",{children:te(n.state)})," at run ",n.run," (",te(n.revision),"):"," ",te(n.sentence),n.ratio===void 0?"":`, ratio ${De(n.ratio)}`,n.note?`; note: ${te(n.note)}`:""," ",h("span",{class:"note",children:te(n.id)})]})}function v2({of:n}){let e=n.points.filter((t,i)=>i===0||t.text!==n.points[i-1].text);return h("p",{class:"note",children:[e.slice(-6).map((t,i)=>h("span",{children:["run ",t.run,": ",h("code",{children:te(t.text??"none")}),";"," "]},i)),on(e.length-1,"time")," another over ",n.points.length," runs"]})}function b2(n){let e=n.points[n.points.length-1];return!e||n.scale==="text"?"":`last ${De(e.value??null)}${n.unit?` ${n.unit}`:""}`}var S2={ratio:"ratio to the pinned binary",absolute:"absolute: another machine or load moves it",value:"value",text:"text"};function M2({of:n}){return h("li",{class:"series",children:[h("h3",{children:[te(n.cell)," ",h("span",{class:"note",children:te(n.metric)})]}),n.scale==="text"?h(v2,{of:n}):h(ub,{of:n}),h("p",{class:"note",children:[S2[n.scale],b2(n)].filter(Boolean).join("; ")}),n.changes.length>0?h("ul",{children:n.changes.map(e=>h(y2,{change:e},e.id))}):null]})}function w2(n){let e=t=>2*+(t.changes.length>0)+ +(t.scale==="ratio");return[...n].sort((t,i)=>e(i)-e(t))}function hb({index:n}){let{series:e=""}=Vn(),[t,i]=lt(Am),s=He(()=>w2(n.histories.flatMap(a=>a.series)),[n]),r=He(()=>{let a=va(`*${e}*`);return s.filter(l=>a(`${l.cell} ${l.metric}`))},[s,e]),o=s.filter(a=>a.changes.length>0).length;return h("section",{"aria-labelledby":"history-heading",children:[h("h2",{id:"history-heading",children:"History"}),s.length===0?h("p",{class:"empty",children:["This report holds no history. ",h("code",{children:"cylon track record"})," adds runs to it,"," ",h("code",{children:"cylon track history --json"})," prints it as JSON; then"," ",h("code",{children:"cylon report FILE\u2026 --html REPORT"}),"."]}):h(Ze,{children:[h("label",{children:["Only series that match"," ",h("input",{type:"search",value:e,onInput:a=>wn({series:a.currentTarget.value}),placeholder:"spring_*/ode* error:*"})]}),h("p",{role:"status",children:[r.length," of ",s.length," series; ",o," with change points, which come first"]})]}),h("ul",{class:"series-list",children:r.slice(0,t).map(a=>h(M2,{of:a},a.series))}),r.length>t?h("button",{type:"button",onClick:()=>i(t+Am),children:["show ",Math.min(Am,r.length-t)," more of ",r.length-t]}):null]})}function db({ratio:n,low:e,high:t,tau:i}){let s=Math.log1p(i),r=Math.max(3*s,...[e,t,n].filter(c=>c>0&&Number.isFinite(c)).map(c=>1.1*Math.abs(Math.log(c)))),o=c=>180/2*(1+Math.max(-1,Math.min(1,Math.log(c)/r))),[a,l]=[o(Math.exp(-s)),o(Math.exp(s))];return h("svg",{class:"interval",width:180,height:18,"aria-hidden":"true",children:[h("rect",{class:"same",x:a,width:l-a,y:"0",height:18}),h("line",{class:"one",x1:180/2,x2:180/2,y1:"0",y2:18}),h("line",{class:"range",x1:o(e),x2:o(t),y1:18/2,y2:18/2}),h("circle",{cx:o(n),cy:18/2,r:"4"})]})}var Em=["regressed","inconclusive","improved","changed","same","skipped"],fb={regressed:"\u2717",improved:"\u2713",same:"=",inconclusive:"?",changed:"\u2260"};function cd(n){let e=Em.indexOf(n);return e<0?Em.length:e}function ld(n){return[n.finding,...n.time?[n.time.finding]:[],...n.metrics.map(t=>t.finding)].sort((t,i)=>cd(t)-cd(i))[0]}function pb({finding:n}){return h("span",{class:`finding ${n}`,children:[fb[n]?`${fb[n]} `:"",te(n)]})}function T2({cell:n,tau:e}){let{time:t}=n;return t?t.ratio===null||t.low===null||t.high===null?h(Ht,{text:t.what}):h(Ze,{children:[h(db,{ratio:t.ratio,low:t.low,high:t.high,tau:e})," ",h("span",{class:"number",children:[De(t.ratio)," [",De(t.low),", ",De(t.high),"]",t.confidence===null?"":` at ${De(100*t.confidence)} %`]}),h("br",{}),h("span",{class:"note",children:[Jn(t.baseline_seconds)," to ",Jn(t.candidate_seconds)," of ",te(t.what),t.adjusted_p===null?"":`, adjusted p ${De(t.adjusted_p,2)}`]})]}):h(Ht,{text:n.untimed||"not timed"})}function A2({cell:n,tau:e}){let t=n.metrics.filter(i=>i.finding!=="same"&&i.sentence!=="");return h("tr",{children:[h("th",{scope:"row",children:te(`${n.scenario} / ${n.engine} at ${n.dt_text}`)}),h("td",{children:h(pb,{finding:ld(n)})}),h("td",{children:h(T2,{cell:n,tau:e})}),h("td",{class:"number",children:n.time?.pairs??""}),h("td",{children:[h(Ht,{text:n.reason}),h("ul",{class:"plain",children:t.map((i,s)=>h("li",{children:[h(pb,{finding:i.finding})," ",te(i.name),": ",h(Ht,{text:i.sentence})]},s))}),n.reproduce?h(rc,{text:n.reproduce}):null]})]})}function mb({of:n,nth:e}){let{list:t,button:i}=Xi([...n.cells].sort((o,a)=>cd(ld(o))-cd(ld(a)))),s=n.cells.map(ld),r=[...new Set([...Em,...s])].map(o=>[s.filter(a=>a===o).length,o]).filter(([o])=>o>0).map(([o,a])=>`${o} ${a}`).join(", ");return h("section",{"aria-labelledby":`comparison-${e}`,children:[h("h3",{id:`comparison-${e}`,children:[te(n.baseline)," and ",te(n.candidate)]}),h("p",{children:[te(r||"no cells"),". Ratios are candidate over baseline; within 1 \xB1"," ",De(100*n.tau)," % (shaded) they count as the same, at \u03B1 = ",De(n.alpha),n.gate?", as a gate over all cells":"","."]}),n.reliable?null:h("p",{class:"warnings",children:[h("strong",{children:"Warning:"})," the environment is unreliable: a build was found different from itself. No time here decides anything."]}),n.notes.length>0?h("ul",{children:n.notes.map((o,a)=>h("li",{children:h(Ht,{text:o})},a))}):null,h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Compared cells",children:h("table",{children:[h("thead",{children:h("tr",{children:["cell","outcome","time, candidate over baseline","pairs","reason, results that changed, command"].map(o=>h("th",{scope:"col",children:o},o))})}),h("tbody",{children:t.map((o,a)=>h(A2,{cell:o,tau:n.tau},a))})]})}),i]})}function E2({cell:n}){let e=n?.verdicts[0];if(!n||!e)return null;let t=e.body_steps>0&&e.cpu_seconds>0,i=Tn(n.worst)&&n.digits!==null?` ${ri(n.digits)}`:"";return h("a",{href:Yn(ws(n)),class:"cost",children:[h("span",{class:"number",children:t?Jn(e.cpu_seconds/e.body_steps):"not timed"})," ",h("span",{class:`status ${$n[n.worst].tone}`,children:[$n[n.worst].glyph,i]})]})}function gb({verdicts:n}){let{columns:e,rows:t}=He(()=>sd(n),[n]),{list:i,button:s}=Xi(t);return h("section",{"aria-labelledby":"costs-heading",children:[h("h3",{id:"costs-heading",children:"CPU time per body-step, with the digits of the worst claim"}),h("p",{class:"note",children:["Timed once, while the verdicts were made and perhaps with other runs beside it: orders of magnitude. To decide between builds there is ",h("code",{children:"cylon track compare"}),", between engines and integrators"," ",h("code",{children:"cylon trade"}),"."]}),h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"CPU time per body-step",children:h("table",{class:"costs",children:[h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"scenario"}),e.map(r=>h("th",{scope:"col",children:te(r.label)},r.label))]})}),h("tbody",{children:i.map(r=>h("tr",{children:[h("th",{scope:"row",children:te(r.label)}),r.cells.map((o,a)=>h("td",{children:h(E2,{cell:o})},a))]},r.label))})]})}),s]})}function _b({index:n}){return h("section",{"aria-labelledby":"performance-heading",children:[h("h2",{id:"performance-heading",children:"Performance"}),n.comparisons.length===0?h("p",{class:"empty",children:["This report holds no comparison of builds."," ",h("code",{children:"cylon track compare --baseline WHAT --json FILE"})," makes one; then"," ",h("code",{children:"cylon report FILE\u2026 --html REPORT"}),"."]}):null,n.comparisons.map((e,t)=>h(mb,{of:e,nth:t},t)),h(gb,{verdicts:n.results.verdicts})]})}var C2=[["cylon","Cylon"],["revision","revision"],["compiler","compiler"],["flags","flags"],["machine","machine"],["os","operating system"],["date","date"],["command_line","command"],["tolerance_scale","tolerances times"]];function Cm({of:n,title:e}){return h(Ze,{children:[h("h3",{children:e}),h("dl",{class:"facts",children:C2.filter(([t])=>n[t]!==void 0&&n[t]!=="").map(([t,i])=>h("div",{children:[h("dt",{children:i}),h("dd",{children:h(Ht,{text:String(n[t])})})]},t))})]})}function R2(n){let e=new Map;for(let t of n){let i=[t.engine,t.version,t.precision,t.path,t.gyroscopic,t.integrator].join("\0"),s=e.get(i);s?++s.verdicts:e.set(i,{first:t,verdicts:1})}return[...e.values()]}function P2({verdicts:n}){let e=He(()=>R2(n),[n]);return h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Engines",children:h("table",{children:[h("caption",{children:"Engines, one row per version, precision, path, gyroscopic mode and integrator"}),h("thead",{children:h("tr",{children:["engine","version","precision","path","gyroscopic","integrator","verdicts"].map(t=>h("th",{scope:"col",children:t},t))})}),h("tbody",{children:e.map(({first:t,verdicts:i},s)=>h("tr",{children:[h("th",{scope:"row",children:te(t.engine)}),h("td",{children:[te(t.version),t.version_listed?"":" (unlisted)"]}),h("td",{children:te(t.precision)}),h("td",{children:te(t.path)}),h("td",{children:te(t.gyroscopic)}),h("td",{children:te(t.integrator)}),h("td",{class:"number",children:i})]},s))})]})})}function I2({verdicts:n}){let e=He(()=>[...new Map(n.map(t=>[t.scenario,t.scenario_hash]))],[n]);return h("details",{children:[h("summary",{children:[on(e.length,"scenario"),": content hashes"]}),h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Hashes of the scenarios",children:h("table",{children:[h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"scenario"}),h("th",{scope:"col",children:"hash"})]})}),h("tbody",{children:e.map(([t,i])=>h("tr",{children:[h("th",{scope:"row",children:te(t)}),h("td",{children:h("code",{children:te(i)})})]},t))})]})})]})}function xb({index:n}){let e=od(n.results);return h("section",{"aria-labelledby":"provenance-heading",children:[h("h2",{id:"provenance-heading",children:"Provenance"}),h("p",{children:e.length>0?e.map(te).join(" "):"No warnings."}),n.omitted_traces?h("p",{children:te(n.omitted_traces)}):null,n.results.verdicts.length>0?h(Cm,{of:n.results.provenance,title:"This run"}):null,n.baseline?h(Cm,{of:n.baseline.provenance,title:"Baseline"}):null,n.trades.map((t,i)=>h(Cm,{of:t.provenance,title:`Speed against accuracy, file ${i+1}`},i)),h(P2,{verdicts:n.results.verdicts}),h(I2,{verdicts:n.results.verdicts})]})}function L2(n,e){let t=i=>[i.engine,i.integrator,i.dt_text,i.tolerance??""].join("\0");return new Map(n.times.filter(i=>i.scenario===e.scenario).map(i=>[t(i),i.cpu_seconds_per_second]))}function D2(n,e,t){let i=n.series[e.series],s=e.reach.map(({error:r,point:o,coarsest_tried:a,why:l})=>{let c=o===null?null:i.points[o],u=c?[i.engine,i.integrator,c.dt_text,c.tolerance??""].join("\0"):"";return{error:r,step:c?.dt??null,tolerance:c?.tolerance??null,cost:t.get(u)??null,coarsestTried:a,why:l}});return{engine:i.engine,version:i.version,integrator:i.integrator,order:i.observed_order,closedForm:i.closed_form??!1,adaptive:i.adaptive,refusal:e.refusal,avoidable:e.avoidable,reach:s,errors:i.points.map(r=>({dt:r.dt,error:r.errors[n.by??""]??null}))}}function yb(n){let e=[],t=[];for(let i of n)for(let s of i.tables){let r=s.measures.find(l=>l.name===s.by);if(!s.cells||!r)continue;let o=L2(i,s),a=s.cells.map(l=>D2(s,l,o));for(let{engine:l}of a)e.includes(l)||e.push(l);t.push({scenario:s.scenario,measure:`${r.name} against ${r.against}`,cells:new Map(a.map(l=>[l.engine,l]))})}return{engines:e,rows:t}}function vb(n){return/^in-house(-float)?(\/|$)/.test(n)}function bb(n,e){let t=n.errors.find(i=>i.dt<=e*1.000000001);return!t||t.error===null?null:{dt:t.dt,digits:Math.min(16,-Math.log10(Math.max(t.error,1e-16)))}}var Sb=[.01,.001,1e-4];function N2(n,e){return n.closedForm?"no steps":e.tolerance!==null?`tolerance ${De(e.tolerance,2)}`:`${e.coarsestTried?"\u2265 ":""}${Jn(e.step)}`}function F2({cell:n,reach:e}){let t=e.step!==null;return h("tr",{class:t?void 0:"not-reached",children:[h("th",{scope:"row",children:De(e.error,1)}),h("td",{children:t?N2(n,e):"not reached"}),h("td",{class:"number",children:t&&e.cost!==null?`${Jn(e.cost)}/s`:""})]})}function U2(n){return n.closedForm?"closed form":n.adaptive?"chooses its steps":n.order===null?"no order seen":`order ${n.order.toFixed(2)}`}function Mb({cell:n}){return h(Ze,{children:[h("strong",{children:n.avoidable?"refused, avoidable":"refused"}),h("p",{class:"why",children:[te(n.refusal),n.avoidable?`; ${te(n.avoidable)} can`:""]})]})}function k2({cell:n}){if(n.refusal)return h(Mb,{cell:n});let e=n.reach.find(t=>t.step===null);return h(Ze,{children:[h("table",{children:h("tbody",{children:n.reach.map(t=>h(F2,{cell:n,reach:t},t.error))})}),h("p",{class:"why",children:[U2(n),e?`; ${De(e.error,1)}: ${te(e.why)}`:""]})]})}function O2({cell:n,dt:e}){if(n.refusal)return h(Mb,{cell:n});if(n.closedForm)return h("span",{class:"why",children:"closed form"});if(n.adaptive)return h("span",{class:"why",children:"chooses its steps"});let t=bb(n,e);return t?h(Ze,{children:[h("span",{class:"number",children:t.digits.toFixed(1)})," ",h("span",{class:"why",children:["at ",Jn(t.dt)]})]}):h("span",{class:"why",children:"no finite error"})}function B2({matrix:n,engines:e,at:t}){return h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Steps by scenario and engine",children:h("table",{class:"steps",children:[h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"scenario"}),e.map(i=>h("th",{scope:"col",children:te(i)},i))]})}),h("tbody",{children:n.rows.map((i,s)=>h("tr",{children:[h("th",{scope:"row",children:[h("a",{href:Yn({...gr("trade"),trade:i.scenario}),children:te(i.scenario)}),h("p",{class:"why",children:te(i.measure)})]}),e.map(r=>{let o=i.cells.get(r);return h("td",{class:o?.avoidable?"avoidable":void 0,children:o?t===null?h(k2,{cell:o}):h(O2,{cell:o,dt:t}):"not run"},r)})]},s))})]})})}function wb({index:n}){let{at:e="",ours:t=""}=Vn(),i=He(()=>yb(n.trades),[n]),s=i.engines.filter(l=>!vb(l)),r=s.length>0&&s.length<i.engines.length,o=r&&t!=="yes"?s:i.engines,a=Sb.find(l=>String(l)===e)??null;return h("section",{"aria-labelledby":"steps-heading",children:[h("h2",{id:"steps-heading",children:"Which step an engine needs"}),i.rows.length===0?h("p",{class:"empty",children:["This report holds no sweep. ",h("code",{children:"cylon matrix --json FILE"})," makes one; then"," ",h("code",{children:"cylon report FILE\u2026 --html REPORT"}),"."]}):h(Ze,{children:[h("div",{class:"choice",children:[h("label",{children:["show"," ",h("select",{value:a===null?"":e,onChange:l=>wn({at:l.currentTarget.value}),children:[h("option",{value:"",children:"the coarsest step that meets an error"}),Sb.map(l=>h("option",{value:String(l),children:["digits at ",Jn(l)]},l))]})]}),r?h("label",{children:[h("input",{type:"checkbox",checked:t==="yes",onChange:()=>wn({ours:t==="yes"?"":"yes"})})," ","with the in-house engine"]}):null]}),h("p",{class:"count",role:"status",children:[on(i.rows.length,"scenario"),", ",on(o.length,"engine")]}),h(B2,{matrix:i,engines:o,at:a}),h("p",{class:"note",children:[a===null?"A line says: relative error; the coarsest of the tried steps that meets it, as the next finer one does; CPU time per simulated second. \u2265: no coarser step was tried. ":"Digits are -log10 of the relative error, at the coarsest tried step of at most the given one. ","no steps, closed form: the engine knows the motion as a formula of time, and a step says nothing of it. A scenario leads to its plot of error against cost."]})]})]})}function Tb(n,e,t,i){return[n,e,t,i??""].join("\0")}function Os(n){return n.error!==null&&n.cost!==null&&n.error>0&&n.cost>0}function V2(n){let e=n.filter(i=>i.error!==null&&i.cost!==null);e.sort((i,s)=>i.cost-s.cost||i.error-s.error);let t=null;for(let i of e)i.onFront=t===null||i.error<t.error,i.dominatedBy="",i.onFront&&(t=i)}function Ab(n,e,t){let i=new Map;for(let r of n.times)r.scenario===e.scenario&&i.set(Tb(r.engine,r.integrator,r.dt_text,r.tolerance),r);let s=e.series.map((r,o)=>({label:`${r.engine} ${r.integrator}`,of:r,points:r.points.map(a=>{let l=i.get(Tb(r.engine,r.integrator,a.dt_text,a.tolerance));return{series:o,dt:a.dt,dtText:a.dt_text,tolerance:a.tolerance,error:a.errors[t]??null,cost:l?.cpu_seconds_per_second??null,perBodyStep:l?.seconds_per_body_step??null,status:a.status,reason:a.reason,onFront:l?.on_front??!1,dominatedBy:l?.dominated_by??""}})}));return t!==e.by&&V2(s.flatMap(r=>r.points)),s}function ud(n){return n.tolerance===null?n.dtText:`${n.dtText}, tolerance ${n.tolerance}`}function Eb({names:n}){return h("thead",{children:h("tr",{children:n.map(e=>h("th",{scope:"col",children:e},e))})})}function z2({of:n}){return n.floor===null?"":`${De(n.floor)}${n.floor_is_rounding?", rounding":", not rounding"}`}function Cb({list:n,hidden:e,toggle:t}){return h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Engines and integrators",children:h("table",{children:[h("caption",{children:"Engines and integrators, with the order fitted to the errors"}),h(Eb,{names:["engine and integrator","version","order declared","order fitted","floor","points drawn","remark"]}),h("tbody",{children:n.map((i,s)=>h("tr",{children:[h("th",{scope:"row",children:h("label",{children:[h("input",{type:"checkbox",class:"on-screen",checked:!e.has(s),onChange:()=>t(s)})," ",h(Ts,{style:s})," ",te(i.label)]})}),h("td",{children:te([i.of.version,i.of.precision,i.of.path,i.of.gyroscopic].filter(Boolean).join(", "))}),h("td",{class:"number",children:i.of.adaptive?"to tolerance":i.of.declared_order}),h("td",{class:"number",children:i.of.observed_order===null?"none":i.of.observed_order.toFixed(2)}),h("td",{class:"number",children:z2(i)}),h("td",{class:"number",children:[i.points.filter(Os).length," of ",i.points.length]}),h("td",{children:h(Ht,{text:i.of.reason})})]},s))})]})})}function hd({list:n,points:e,caption:t}){let{list:i,button:s}=Xi(e);return e.length===0?null:h(Ze,{children:[h("div",{class:"scroll",tabIndex:0,role:"region","aria-label":t,children:h("table",{children:[h("caption",{children:[t," (",e.length,")"]}),h(Eb,{names:["engine and integrator","step and tolerance","error","CPU s per s","per body-step","status","dominated by, or why not"]}),h("tbody",{children:i.map((r,o)=>h("tr",{children:[h("th",{scope:"row",children:te(n[r.series].label)}),h("td",{class:"number",children:te(ud(r))}),h("td",{class:"number",children:De(r.error)}),h("td",{class:"number",children:r.cost===null?"not timed":De(r.cost)}),h("td",{class:"number",children:Jn(r.perBodyStep)}),h("td",{children:h(rs,{status:r.status})}),h("td",{children:h(Ht,{text:r.dominatedBy||r.reason})})]},o))})]})}),s]})}function Rb(n){let e=Vt(null),[t,i]=lt(n);return Rt(()=>{if(!e.current)return;let s=new ResizeObserver(([r])=>r&&i(Math.max(240,Math.floor(r.contentRect.width))));return s.observe(e.current),()=>s.disconnect()},[]),[e,t]}function Rm(n,e,t){let[i,s]=[1/0,-1/0];for(let u of n)i=Math.min(i,u),s=Math.max(s,u);i>0&&Number.isFinite(s)||([i,s]=[.1,1]);let r=Math.floor(Math.log10(i)+1e-9),o=Math.max(r+1,Math.ceil(Math.log10(s)-1e-9)),a=u=>e+(Math.log10(u)-r)/(o-r)*(t-e),l=Math.max(1,Math.ceil((o-r)*40/Math.abs(t-e))),c=[];for(let u=r;u<=o;u+=l)c.push({value:10**u,at:a(10**u),label:`1e${u}`});return{place:a,ticks:c}}var dd=480,gi={left:62,right:14,top:12,bottom:46},G2=30;function H2({x:n,y:e,width:t,error:i}){let[s,r]=[dd-gi.bottom,t-gi.right];return h("g",{class:"grid",children:[n.ticks.map(({at:o,label:a})=>h("g",{children:[h("line",{x1:o,x2:o,y1:gi.top,y2:s}),h("text",{x:o,y:s+16,"text-anchor":"middle",children:a})]},a)),e.ticks.map(({at:o,label:a})=>h("g",{children:[h("line",{x1:gi.left,x2:r,y1:o,y2:o}),h("text",{x:gi.left-6,y:o+4,"text-anchor":"end",children:a})]},a)),h("text",{x:(gi.left+r)/2,y:dd-8,"text-anchor":"middle",children:"CPU seconds per simulated second"}),h("text",{transform:`translate(14 ${(gi.top+s)/2}) rotate(-90)`,"text-anchor":"middle",children:te(i)})]})}function W2({placed:n,style:e}){let{color:t,dash:i,marker:s}=Hi(e),r=`var(${t})`;return h("g",{children:[h("polyline",{points:n.map(({x:o,y:a})=>`${o.toFixed(1)},${a.toFixed(1)}`).join(" "),stroke:r,"stroke-dasharray":i.join(" ")}),n.map(({point:o,x:a,y:l},c)=>h("g",{children:[o.onFront?h("circle",{class:"front",cx:a,cy:l,r:"8"}):null,h("path",{d:To(s,a,l,4.5),fill:r})]},c))]})}function $2(n,e){let t=e.onFront?"nothing is both cheaper and better":e.dominatedBy&&`dominated by ${e.dominatedBy}`;return te([`${n[e.series].label} at ${ud(e)}`,`error ${De(e.error)}`,`${De(e.cost)} CPU s/s`,`${Jn(e.perBodyStep)} per body-step`,t].filter(Boolean).join("; "))}function Pb({list:n,hidden:e,error:t,level:i,label:s}){let[r,o]=Rb(900),[a,l]=lt(null),{x:c,y:u,lines:f}=He(()=>{let p=n.flatMap(g=>g.points.filter(Os)),m=Rm(p.map(g=>g.cost),gi.left,o-gi.right),v=Rm([...p.map(g=>g.error),...i?[i]:[]],dd-gi.bottom,gi.top),_=g=>({point:g,x:m.place(g.cost),y:v.place(g.error)});return{x:m,y:v,lines:n.map(g=>g.points.filter(Os).map(_))}},[n,o,i]),d=p=>{let m=p.currentTarget.getBoundingClientRect(),v=g=>Math.hypot(g.x-(p.clientX-m.left),g.y-(p.clientY-m.top)),_=f.flatMap((g,y)=>e.has(y)?[]:g).sort((g,y)=>v(g)-v(y))[0];l(_&&v(_)<G2?_.point:null)};return h("div",{ref:r,class:"trade-plot",children:[h("svg",{width:o,height:dd,role:"img","aria-label":te(s),onPointerMove:d,onPointerLeave:()=>l(null),children:[h(H2,{x:c,y:u,width:o,error:t}),i?h("g",{class:"level",children:[h("line",{x1:gi.left,x2:o-gi.right,y1:u.place(i),y2:u.place(i)}),h("text",{x:o-gi.right-4,y:u.place(i)-5,"text-anchor":"end",children:["allowed ",De(i)]})]}):null,f.map((p,m)=>e.has(m)?null:h(W2,{placed:p,style:m},m))]}),h("p",{class:"named on-screen",children:a?$2(n,a):"Point at a setting to read it; every one stands in the tables below."})]})}function X2(n){return n.flatMap((e,t)=>e.tables.map(i=>({key:n.length>1?`${i.scenario} (${t+1})`:i.scenario,trade:e,table:i})))}function q2(n,e,t){if(t.scale===null)return null;let i=n.filter(s=>s.scenario===e.scenario&&s.scenario_hash===e.scenario_hash&&s.observable===t.name).flatMap(s=>s.allowed!==null&&s.allowed>0&&s.unit===t.unit?[s.allowed]:[]);return i.length>0?Math.min(...i)/t.scale:null}function Ib(n){let e=n.scale===null?"":`, over ${De(n.scale)} ${n.unit}`;return`error of ${n.name}${e}, against ${n.against}`}function Y2(n){return`Error against cost. ${n.map(t=>{let i=Math.min(...t.points.filter(Os).map(s=>s.error));return`${t.label}: ${Number.isFinite(i)?`least error ${De(i)}`:"no finite error"}`}).join(". ")}.`}function J2({index:n,entry:e}){let{measure:t,hide:i=""}=Vn(),{trade:s,table:r}=e,o=r.measures.find(d=>d.name===t)??r.measures.find(d=>d.name===r.by)??r.measures[0],a=He(()=>Ab(s,r,o?.name??""),[s,r,o]),l=He(()=>new Set(i.split(",").filter(Boolean).map(Number)),[i]);if(!o)return h("p",{class:"empty",children:"This sweep measured no errors."});let c=d=>{let p=new Set(l);p.delete(d)||p.add(d),wn({hide:[...p].join(",")})},u=a.flatMap(d=>d.points).sort((d,p)=>(d.cost??1/0)-(p.cost??1/0)),f=u.filter(d=>!Os(d));return h(Ze,{children:[h("label",{children:["measure"," ",h("select",{value:o.name,onChange:d=>wn({measure:d.currentTarget.value}),children:r.measures.map(d=>h("option",{value:d.name,children:te(d.name)},d.name))})]}),h("p",{class:"note",children:[te(Ib(o)),"; the reference itself is known to ",De(o.resolution),". Truth: ",te(r.truth||"none"),"; ",De(r.duration)," s,"," ",on(r.bodies,"body","bodies"),". Ringed (the Pareto front): no other setting is both faster and more accurate",o.name===r.by?".":" by this measure.",f.length>0?` ${on(f.length,"setting")} cannot be drawn, because the error is 0 or not finite, or because no time was measured. The last table lists them.`:""]}),h(Pb,{list:a,hidden:l,error:Ib(o),level:q2(n.results.verdicts,r,o),label:Y2(a)}),h(Cb,{list:a,hidden:l,toggle:c}),h(hd,{list:a,points:u.filter(d=>Os(d)&&d.onFront),caption:"Pareto front: no other setting is both faster and more accurate"}),h(hd,{list:a,points:u.filter(d=>Os(d)&&!d.onFront),caption:"Other settings, each with one that is both faster and more accurate"}),h(hd,{list:a,points:f,caption:"Not drawn"})]})}function Lb({index:n}){let{trade:e}=Vn(),t=He(()=>X2(n.trades),[n]),i=t.find(s=>s.key===e)??t[0];return h("section",{"aria-labelledby":"trade-heading",children:[h("h2",{id:"trade-heading",children:"Speed against accuracy"}),i?h(Ze,{children:[h("label",{children:["scenario"," ",h("select",{value:i.key,onChange:s=>wn({trade:s.currentTarget.value,measure:"",hide:""}),children:t.map(({key:s})=>h("option",{value:s,children:te(s)},s))})]})," ",h(J2,{index:n,entry:i},i.key)]}):h("p",{class:"empty",children:["This report holds no sweep. ",h("code",{children:"cylon trade SCENARIO --json FILE"})," makes one; then"," ",h("code",{children:"cylon report FILE\u2026 --html REPORT"}),"."]})]})}var kl=n=>n.reduce((e,{length:t})=>e+t,0),Ol=[{id:"matrix",label:"Verdicts",view:null,size:n=>n.results.verdicts.length},{id:"steps",label:"Steps",view:wb,size:n=>kl(n.trades.map(e=>e.tables.filter(({cells:t})=>t)))},{id:"trade",label:"Speed against accuracy",view:Lb,size:n=>kl(n.trades.map(e=>e.tables))},{id:"performance",label:"Performance",view:_b,size:n=>kl(n.comparisons.map(e=>e.cells))},{id:"history",label:"History",view:hb,size:n=>kl(n.histories.map(e=>e.series))},{id:"faults",label:"Faults",view:lb,size:n=>kl(n.hunts.map(e=>e.cards))},{id:"provenance",label:"Provenance",view:xb,size:()=>null}];var Pm={auto:{next:"light",label:"Colours: as the system"},light:{next:"dark",label:"Colours: light"},dark:{next:"auto",label:"Colours: dark"}};function Z2(){let[n,e]=lt(pg());return h("button",{type:"button",class:"theme",onClick:()=>{mg(Pm[n].next),e(Pm[n].next)},children:Pm[n].label})}function K2({index:n,open:e}){return h("nav",{"aria-label":"Parts of the report",children:h("ul",{children:Ol.map(({id:t,label:i,size:s})=>{let r=s(n);return h("li",{children:h("a",{href:Yn(gr(t)),"aria-current":t===e?"page":void 0,children:[i,r===null?"":` (${r})`]})},t)})})})}function Db({index:n}){let e=Vn(),t=He(()=>sd(n.results.verdicts),[n]),i=He(()=>new Map(n.scenarios.map(d=>[d.name,d])),[n]),s=Ol.find(({size:d})=>d(n)!==0),r=Ol.find(d=>d.id===e.section)??s??Ol[0],o=Ig(e),a=r.view,l=He(()=>o?zv(t,o):null,[t,o?.scenario,o?.engine,o?.integrator,o?.dt]),c=Vt(null),u=o?`${o.scenario} / ${o.engine}`:r.label;Rt(()=>{document.title=te(`${u} - ${n.title}`)},[u,n]);let f=Vt(!1);return bi(()=>{f.current&&!o&&!a&&document.querySelector('.matrix [tabindex="0"]')?.focus(),f.current=o!==null}),h(Ze,{children:[h("header",{children:[h("a",{class:"skip",href:"#content",onClick:d=>{d.preventDefault(),c.current?.focus()},children:"Skip to the content"}),h("h1",{children:te(n.title)}),h(Z2,{}),h(ob,{index:n,matrix:t}),h(K2,{index:n,open:o?"":r.id})]}),h("main",{id:"content",ref:c,tabIndex:-1,children:[h("div",{class:o||a?"paper-only":void 0,children:[h(ab,{index:n}),h(tb,{matrix:t,views:i})]}),!o&&a?h(a,{index:n}):null,o&&l?h(Ov,{index:n,matrix:t,cell:l,view:i.get(l.scenario)}):null,o&&!l?h("p",{role:"alert",children:["The report has no run of ",te(o.scenario)," by ",te(o.engine)," ",te(o.integrator)," at ",te(o.dt)," s."," ",h("a",{href:Yn(gr("matrix")),children:"All runs"})]}):null]})]})}function j2({why:n}){return h("main",{children:[h("h1",{children:"This report cannot be read"}),h("p",{role:"alert",children:n})]})}var Q2={cylon:"",revision:"",compiler:"",flags:"",machine:"",os:"",date:"",command_line:"",tolerance_scale:1};function e3(n){return n.results?n:{...n,results:{schema:1,provenance:Q2,verdicts:[]}}}function Nb(n){ec(),Rg(),hg(0).then(e=>{let t=e3(e);n.replaceChildren(),La(h(Db,{index:t}),n)},e=>La(h(j2,{why:String(e)}),n))}var Fb=[["Space","play or pause"],[".","one step, then pause"],["R","reset"],["1 \u2026 9","kick body 1 \u2026 9; with Shift the other way"],["[ and ]","slower, faster"],["V, M, L","arrows of velocity, momentum, angular momentum"],["T, C, J","trails, contacts, springs and joints"],["Arrows, + and \u2212","turn and zoom the picture with the focus; with Shift move it"],["Home","frame all"],["Drag","turns the picture; on a body, pulls it by a spring. Shift or right button moves the picture"],["?","this list"]];function t3(n){let e=n.target;return e?.matches?e.matches("input:not([type=checkbox]):not([type=range]), select, textarea")?!0:n.key===" "&&e.matches("button, input, summary, a"):!1}function Ub(n,e){let t=r=>()=>n.show({[r]:!n.shown[r]}),i=r=>()=>n.send({do:"speed",value:Math.min(100,Math.max(.01,n.speed*r))}),s={" ":()=>n.toggle(),".":()=>n.send({do:"step"}),r:()=>n.send({do:"reset"}),"[":i(.6666666666666666),"]":i(1.5),v:t("velocity"),m:t("momentum"),l:t("angular momentum"),t:t("trails"),c:t("contacts"),j:t("links"),"?":e};return r=>{if(r.ctrlKey||r.metaKey||r.altKey||r.defaultPrevented||t3(r))return;let o=/^(?:Digit|Numpad)([1-9])$/.exec(r.code),a=o?()=>n.kick(Number(o[1])-1,r.shiftKey):s[r.key.length===1?r.key.toLowerCase():r.key];!a||r.repeat&&r.key!=="."||(a(),r.preventDefault())}}function kb({dialog:n}){return h("dialog",{ref:n,class:"help","aria-labelledby":"help-title",children:[h("h2",{id:"help-title",children:"Keys"}),h("dl",{children:Fb.map(([e,t])=>h("div",{children:[h("dt",{children:h("kbd",{children:e})}),h("dd",{children:t})]},e))}),h("form",{method:"dialog",children:h("button",{children:"Close"})})]})}var Ob=["energy","momentum","angular momentum"],pd={energy:"J",momentum:"kg m/s","angular momentum":"kg m\xB2/s"},Bb=["size","x","y","z"];function Im(n,e,t){if(n.status!=="running")return null;if(e==="energy")return n.energy;let i=e==="momentum"?n.momentum:n.angular_momentum;return!Array.isArray(i)||!i.every(s=>Number.isFinite(s))?null:t==="size"?Math.hypot(...i):i["xyz".indexOf(t)]}var fd=class{constructor(e=1200){this.most=e}most;samples=[];first=null;add(e,t){let i=this.samples[this.samples.length-1];i&&(e<i.t||t.length!==i.lanes.length)&&this.clear(),i&&e===i.t&&this.samples.pop();let s={t:e,lanes:t.map(({status:r,energy:o,momentum:a,angular_momentum:l})=>({status:r,energy:o,momentum:a,angular_momentum:l}))};this.first??=s,this.samples.push(s),this.samples.length>this.most&&this.samples.splice(0,Math.floor(this.most/4))}clear(){this.samples.length=0,this.first=null}times(){return this.samples.map(e=>e.t)}series(e,t,i){return this.samples.map(s=>s.lanes[e]?Im(s.lanes[e],t,i):null)}};function ar(n){if(n==null||!Number.isFinite(n))return"not finite";let e=Math.abs(n);return e!==0&&(e>=1e6||e<1e-4)?n.toExponential(5):n.toPrecision(6)}function Vb(n,e){if(n==null||e==null)return[-1,1];let t=Math.max(Math.abs(n),Math.abs(e)),i=e>n?.08*(e-n):t>0?.001*t:1;return[n-i,e+i]}var zb=[.3/Math.hypot(.3,1),1/Math.hypot(.3,1),0],n3=(2*Math.PI)**2;function md(n,e,t){let i=n.body[e];return!i||i.locked||!(i.mass>0)||!Number.isFinite(t)?null:[i.mass*t*zb[0],i.mass*t*zb[1],0]}var Gb=(n,e)=>(n>0?n:1)*n3*e**2;var i3=9;function Hb({viewer:n,scene:e}){let t=(i,s,r,o)=>h("label",{children:[s,h("input",{type:"number",class:"number",min:.01,step:"any",value:i,onChange:a=>{let l=a.currentTarget.valueAsNumber;l>0&&Number.isFinite(l)&&o(l),a.currentTarget.value=String(l>0?l:i),n.changed()}}),r]});return h("section",{class:"panel",children:[h("h2",{children:"Kick and pull"}),h("div",{class:"choices",children:[t(n.kickSpeed,"Kick by","m/s",i=>n.kickSpeed=i),t(n.pullFrequency,"Pull at","Hz",i=>n.pullFrequency=i)]}),h("ul",{class:"kicks",children:e.body.slice(0,i3).map((i,s)=>{let r=md(e,s,n.kickSpeed);return h("li",{children:[h("button",{type:"button",disabled:!r,title:"with Shift the other way",onClick:o=>n.kick(s,o.shiftKey),children:[h("kbd",{children:s+1})," ",i.name]}),h("span",{class:"muted number",children:r?`${ar(Math.hypot(...r))} N s`:"locked"})]},i.name)})})]})}var s3=4;function r3(n){let e=/^\s*(\d*\.?\d+(?:e[-+]?\d+)?)\s*(?:\/\s*(\d*\.?\d+(?:e[-+]?\d+)?))?\s*$/i.exec(n),t=e?Number(e[1])/Number(e[2]??1):NaN;return Number.isFinite(t)&&t>0}function o3({lane:n,engines:e,name:t,change:i}){let[s,r]=lt(n.dt_text),o=e.find(c=>c.id===n.engine)?.integrators??[],a=!r3(s),l=()=>{!a&&s.trim()!==n.dt_text&&i({...n,dt_text:s.trim()})};return h(Ze,{children:[h("select",{"aria-label":`engine of ${t}`,value:n.engine,onChange:c=>i({...n,engine:c.currentTarget.value,integrator:""}),children:[!e.some(c=>c.id===n.engine)&&h("option",{value:n.engine,children:n.engine}),e.map(c=>h("option",{value:c.id,children:[c.id," ",c.version]},c.id))]}),h("select",{"aria-label":`integrator of ${t}`,value:n.integrator,onChange:c=>i({...n,integrator:c.currentTarget.value}),children:[h("option",{value:"",children:"default"}),o.map(c=>h("option",{value:c,children:c},c))]}),h("input",{type:"text",class:"number step","aria-label":`step of ${t} in seconds`,"aria-invalid":a,value:s,onInput:c=>r(c.currentTarget.value),onBlur:l,onKeyDown:c=>c.key==="Enter"&&l()})]})}function Wb({viewer:n,session:e}){let{lanes:t,engines:i}=e,s=o=>n.send({do:"lanes",lanes:o}),r=i.find(o=>!t.some(a=>a.engine===o.id))??i[0];return h("section",{class:"panel",children:[h("h2",{children:"Lanes"}),h("p",{class:"muted",children:"Engine, integrator and step [s]; the state is kept."}),h("ol",{class:"lane-list",children:t.map((o,a)=>h("li",{children:[h(o3,{lane:o,engines:i,name:`lane ${a+1}`,change:l=>s(t.map((c,u)=>u===a?l:c))}),h("button",{type:"button",disabled:t.length<2,"aria-label":`remove lane ${a+1}`,onClick:()=>s(t.filter((l,c)=>c!==a)),children:"\xD7"})]},`${a} ${o.engine} ${o.integrator} ${o.dt_text}`))}),h("button",{type:"button",disabled:t.length>=s3||!r,onClick:()=>r&&s([...t,{engine:r.id,integrator:"",dt_text:t[0]?.dt_text??"1/240"}]),children:"Add a lane"})]})}function $b(n){switch(n.do){case"pull":case"speed":return n.do;case"set":return`set ${n.key}`;default:return null}}var gd=class{constructor(e,t){this.post=e;this.failed=t}post;failed;waiting=[];busy=!1;put(e){let t=this.waiting[this.waiting.length-1],i=$b(e);t&&i!==null&&$b(t)===i&&this.waiting.pop(),this.waiting.push(e)}flush(){if(this.busy)return;let e=this.waiting.shift();e&&(this.busy=!0,this.post(e).catch(t=>this.failed(t instanceof Error?t.message:String(t))).finally(()=>this.busy=!1))}clear(){this.waiting.length=0}};var _d=class{bytes=new Uint8Array(65536);begin=0;end=0;text=new TextDecoder;push(e){this.append(e);let t=[];for(let i=this.next();i;i=this.next())t.push(i);return t}append(e){let t=this.end-this.begin;if(this.end+e.length>this.bytes.length){let i=t+e.length>this.bytes.length?new Uint8Array(2*(t+e.length)):this.bytes;i.set(this.bytes.subarray(this.begin,this.end)),this.bytes=i,[this.begin,this.end]=[0,t]}this.bytes.set(e,this.end),this.end+=e.length}next(){if(this.end-this.begin<8)return null;let e=new DataView(this.bytes.buffer,this.begin,8),[t,i]=[e.getUint32(0,!0),e.getUint32(4,!0)];if(t>67108864||i>268435456||i%4!==0)throw new Error(`the stream is out of step: a header of ${t} and a payload of ${i} bytes`);if(this.end-this.begin<8+t+i)return null;let s=this.begin+8,r=JSON.parse(this.text.decode(this.bytes.subarray(s,s+t))),o=new Float32Array(this.bytes.slice(s+t,s+t+i).buffer);return this.begin+=8+t+i,{message:r,payload:o}}};var a3=(n,e)=>new Promise(t=>{let i=setTimeout(t,1e3*n);e.addEventListener("abort",()=>(clearTimeout(i),t()),{once:!0})}),xd=class{constructor(e){this.listener=e}listener;token=document.querySelector('meta[name="cylon-token"]')?.content??"";stop=new AbortController;async run(){let e=.25;for(;!this.stop.signal.aborted;){try{let t=await(await this.ask("/api/session")).json(),i=await this.ask("/api/stream");this.listener.session(t),this.listener.connected(!0,""),e=.25,await this.read(i),this.listener.connected(!1,"the server closed the stream")}catch(t){if(this.stop.signal.aborted)return;this.listener.connected(!1,t instanceof Error?t.message:String(t))}await a3(e,this.stop.signal),e=Math.min(2*e,4)}}async read(e){let t=e.body.getReader(),i=new _d;try{for(;;){let{done:s,value:r}=await t.read();if(s)return;for(let o of i.push(r))this.listener.packet(o)}}finally{t.cancel().catch(()=>{})}}async ask(e,t,i="application/json"){let s={"X-Cylon-Token":this.token};t!==void 0&&(s["Content-Type"]=i);let r=await fetch(e,{method:t===void 0?"GET":"POST",headers:s,body:t,signal:this.stop.signal,cache:"no-store"});if(r.ok)return r;if(r.status===403)throw new Error("another server answers here than the one of this page; reload the page");let o=await r.text(),a=o.slice(0,400);try{a=JSON.parse(o).error??a}catch{}throw new Error(a||`${e}: ${r.status}`)}async command(e){await this.ask("/api/command",JSON.stringify(e))}async frame(e,t){await this.ask(`/api/frame?n=${e}`,t,"image/png")}close(){this.stop.abort()}};var Xb=n=>n.recording!==""&&!/\.toml$/i.test(n.recording);function l3(n,e,t){let i=e.reduce((l,c)=>l+c.size.width,0),s=24+Math.max(...e.map(l=>l.size.height));(n.width!==i||n.height!==s)&&([n.width,n.height]=[i,s]);let r=n.getContext("2d",{willReadFrequently:!0}),o=getComputedStyle(document.documentElement);r.fillStyle=o.getPropertyValue("--ground").trim()||"#ffffff",r.fillRect(0,0,i,s),r.fillStyle=o.getPropertyValue("--ink").trim()||"#000000",r.font="14px system-ui, sans-serif";let a=0;return e.forEach((l,c)=>{r.fillText(t[c]??"",a+8,17),l.paint(r,a,24),a+=l.size.width}),new Promise((l,c)=>n.toBlob(u=>u?l(u):c(new Error("the picture could not be kept")),"image/png"))}var yd=class{constructor(e,t,i){this.send=e;this.failed=t;this.slower=i}send;failed;slower;last=-1;busy=!1;stopped=!1;slowed=0;canvas=document.createElement("canvas");reset(){this.last=-1,this.stopped=!1}take(e,t,i,s){let r=Math.floor(e*30+1e-6);this.stopped||i.length===0||r<=this.last||(r>this.last+1&&this.last>=0&&t-this.slowed>700&&(this.slowed=t,this.slower()),!this.busy&&(this.last=r,this.busy=!0,l3(this.canvas,i,s).then(o=>this.send(r,o)).catch(o=>{this.stopped=!0,this.failed(`recording stopped: ${o instanceof Error?o.message:String(o)}`)}).finally(()=>this.busy=!1)))}};var vd=class{times=[];start=-1;total={frames:0,seconds:0};constructor(){window.cylonFrames=this.total}tick(e){for(this.start<0&&(this.start=e),++this.total.frames,this.total.seconds=(e-this.start)/1e3,this.times.push(e);this.times[0]<e-1e3;)this.times.shift()}get perSecond(){let e=this.times.length;return e<2?0:1e3*(e-1)/(this.times[e-1]-this.times[0])}};var Lm=13,Bl=class{constructor(e){this.bodies=e;this.position=new Float32Array(3*e),this.orientation=new Float32Array(4*e),this.velocity=new Float32Array(3*e),this.spin=new Float32Array(3*e)}bodies;position;orientation;velocity;spin;read(e,t){let i=t*this.bodies*Lm;if(e.length<i+this.bodies*Lm)return!1;for(let s=0;s<this.bodies;++s){let r=i+s*Lm;for(let o=0;o<3;++o)this.position[3*s+o]=e[r+o],this.velocity[3*s+o]=e[r+7+o],this.spin[3*s+o]=e[r+10+o];for(let o=0;o<4;++o)this.orientation[4*s+o]=e[r+3+o]}return!0}vector(e,t){return[e[3*t],e[3*t+1],e[3*t+2]]}angularMomentum(e,t){let i=this.orientation,s=[i[4*t],i[4*t+1],i[4*t+2],i[4*t+3]],r=Yt(qi(s),this.vector(this.spin,t)),o=e.body[t].inertia,a=l=>o[3*l]*r[0]+o[3*l+1]*r[1]+o[3*l+2]*r[2];return Yt(s,[a(0),a(1),a(2)])}},bd=class{largest=new Map;of(e){return this.largest.get(e)??0}impulse=0;see(e){for(let{impulse:t}of e)Number.isFinite(t)&&(this.impulse=Math.max(this.impulse,t))}clear(){this.largest.clear(),this.impulse=0}arrows(e,t,i,s){let r=[];for(let o of i)for(let a=0;a<t.bodies;++a){let l=e.body[a];if(!l||l.locked)continue;let c=o==="angular momentum"?t.angularMomentum(e,a):t.vector(t.velocity,a),u=o==="momentum"?l.mass:1,f=u*Math.hypot(...c);!Number.isFinite(f)||f===0||(f>this.of(o)&&this.largest.set(o,f),r.push({at:t.vector(t.position,a),along:[u*c[0],u*c[1],u*c[2]],kind:o}))}for(let o of r){let a=s/this.of(o.kind);o.along=[a*o.along[0],a*o.along[1],a*o.along[2]]}return r}};var Vl=class{constructor(e,t=6e4){this.bodies=e;this.most=Math.max(32,Math.min(1e3,Math.floor(t/Math.max(e,1)))),this.positions=this.room()}bodies;positions;frames=0;most;room(){return new Float32Array(3*this.bodies*this.most)}add(e){let t=3*this.bodies;if(this.frames===this.most){let i=this.most>>1,s=this.room();s.set(this.positions.subarray((this.most-i)*t)),this.positions=s,this.frames=i}this.positions.set(e,this.frames*t),++this.frames}clear(){this.positions=this.room(),this.frames=0}};var Sd=class{constructor(e,t,i,s){this.scene=t;this.picture=Qh(e,t,{label:i}),this.pose=new Bl(t.body.length),this.trail=new Vl(t.body.length),this.arrowLength=this.reach(),this.picture.onCamera=r=>s.camera(r,this),this.picture.onFrameAll=()=>s.frameAll(),this.picture.onGrab=r=>s.grab(r),this.picture.onPull=r=>s.pull(r),this.picture.onRelease=()=>s.release()}scene;picture;pose;trail;arrowLength;time=-1/0;reach(){let{min:e,max:t}=ko(this.scene);return .25*Tt(mt(t,e))}setScene(e,t){this.scene=e,t&&(this.picture.replaceScene(e),this.pose=new Bl(e.body.length),this.trail=new Vl(e.body.length),this.arrowLength=this.reach(),this.time=-1/0)}read(e,t,i){return this.pose.read(t,i)?(e<this.time&&this.trail.clear(),e!==this.time&&this.trail.add(this.pose.position),this.time=e,!0):!1}get position(){return this.pose.position}update(e,t,i,s,r){let{picture:o,pose:a,scene:l}=this;if(t.status!=="running"||this.time===-1/0)return;o.show("bodies",a,e.t),o.links(i.links),o.trails("bodies",i.trails?this.trail.positions:null,a.bodies,this.trail.frames-1);let c=["velocity","momentum","angular momentum"].filter(u=>i[u]);o.arrows(s.arrows(l,a,c,this.arrowLength)),o.contacts(i.contacts?t.contacts:[],s.impulse),o.pulls(e.pulls.filter(u=>u.body<a.bodies).map(({body:u,pin:f})=>{let d=a.orientation,p=[d[4*u],d[4*u+1],d[4*u+2],d[4*u+3]];return{from:je(a.vector(a.position,u),Yt(p,r.get(u)??[0,0,0])),to:f}}))}dispose(){this.picture.dispose()}};var zl=(n,e)=>typeof n[e]=="string"?n[e]:"",c3=n=>Array.isArray(n.between)?n.between.join(" \u2013 "):"",u3=[{list:"spring",title:n=>`spring ${zl(n,"body")} \u2013 ${zl(n,"to")||"pin"}`,columns:[{name:"stiffness",label:"stiffness",unit:"N/m",least:0},{name:"rest_length",label:"rest length",unit:"m",least:0},{name:"damping",label:"damping",unit:"N s/m",least:0}]},{list:"drag",title:n=>`drag of ${zl(n,"body")}`,columns:[{name:"linear",label:"linear",unit:"kg/s",least:0},{name:"angular",label:"angular",unit:"kg m\xB2/s",least:0},{name:"momentum",label:"momentum",unit:"1/s",least:0}]},{list:"attraction",title:n=>`attraction ${zl(n,"body")} \u2013 ${zl(n,"to")}`,columns:[{name:"strength",label:"strength",unit:"m\xB3/(kg s\xB2)"}]},{list:"water",title:()=>"water",columns:[{name:"level",label:"level",unit:"m"},{name:"buoyancy",label:"buoyancy",unit:"",least:0},{name:"drag",label:"drag",unit:"kg/s",least:0}]},{list:"material",title:n=>`contact ${c3(n)}`,columns:[{name:"restitution",label:"restitution",unit:"",least:0,most:1},{name:"friction",label:"friction",unit:"",least:0}]}];function qb(n){let e=[{key:"gravity",group:"gravity",label:"gravity",unit:"m/s\xB2",value:n.gravity,least:-1/0,most:1/0}];for(let{list:t,title:i,columns:s}of u3)(Array.isArray(n[t])?n[t]:[]).forEach((o,a)=>{for(let{name:l,label:c,unit:u,least:f=-1/0,most:d=1/0}of s)typeof o[l]=="number"&&e.push({key:`${t}.${a}.${l}`,group:i(o),label:c,unit:u,value:o[l],least:f,most:d})});for(let t of n.body)t.locked||e.push({key:`body.${t.name}.mass`,group:"masses",label:t.name,unit:"kg",value:t.mass,least:Number.MIN_VALUE,most:1/0});return e}function Yb(n,e){let t=Number(e.trim());return e.trim()===""||!Number.isFinite(t)?{error:"a number, please"}:t<n.least||t>n.most?{error:n.most===1/0?`must be at least ${n.least===Number.MIN_VALUE?"above 0":n.least}`:`must lie in ${n.least} \u2026 ${n.most}`}:{value:t}}function Jb(n){return JSON.stringify([n.body.map(e=>[e.name,e.shape,e.color,e.locked,e.position,e.orientation]),n.joint,n.spring.map(e=>[e.body,e.anchor,e.to,e.to_anchor,e.pin]),n.plane,n.water])}var Zb=.15,h3=6,Md=class{bounds;limit;radius;constructor(e,t){this.bounds=ko(e);let i=Math.max(0,...e.body.map(o=>Tt(o.velocity)).filter(Number.isFinite)),s=Math.max(Tt(e.gravity),...e.body.map(o=>Tt(o.gravity??[0,0,0]))),r=i*t+s*t**2/2;this.limit=Math.max(h3*Tt(mt(this.bounds.max,this.bounds.min)),10*r),this.radius=e.body.map(o=>Rc(Uo(o)))}include(e){let t=!1,i=Tt(mt(this.bounds.max,this.bounds.min));for(let s=0;s<3*this.radius.length;++s){let r=s%3,o=e[s],a=this.radius[(s-r)/3];!Number.isFinite(o)||Math.abs(o-(this.bounds.min[r]+this.bounds.max[r])/2)>this.limit||o-a>=this.bounds.min[r]&&o+a<=this.bounds.max[r]||(t||(this.bounds={min:[...this.bounds.min],max:[...this.bounds.max]}),t=!0,o-a<this.bounds.min[r]?this.bounds.min[r]=o-a-Zb*i:this.bounds.max[r]=o+a+Zb*i)}return t}};var d3=200,f3=125,Bi=n=>[n.engine,n.integrator,`dt ${n.dt_text}`].filter(e=>e).join(" \xB7 "),wd=class{session=null;state=null;connected=!1;why="connecting";notice="";shown={velocity:!1,momentum:!1,"angular momentum":!1,trails:!1,contacts:!0,links:!0};kickSpeed=1;pullFrequency=1;history=new fd;scale=new bd;rate=new vd;pictures=new Map;listeners=new Set;anchors=new Map;connection=new xd({session:e=>this.take(e),packet:e=>this.packet(e),connected:(e,t)=>this.setConnected(e,t)});commands=new gd(e=>this.connection.command(e),e=>this.tell(e));film=new yd((e,t)=>this.connection.frame(e,t),e=>this.tell(e),()=>{this.send({do:"speed",value:Math.max(.01,this.speed/1.5)}),this.tell("Pictures were missed: the motion was slowed down for the recording. Reset records from the start.")});fresh=!1;payload=null;reach=null;looks="";camera=null;grabbed=null;told=0;start(){this.connection.run();let e=t=>{this.frame(t),requestAnimationFrame(e)};requestAnimationFrame(e)}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}changed(){for(let e of this.listeners)e()}tell(e){this.notice=e,this.changed()}setConnected(e,t){this.connected=e,this.why=t,e?this.notice="":this.commands.clear(),this.changed()}take(e){let t=this.session;this.session=e,t||(this.shown={...this.shown,contacts:e.scene.body.length<=d3}),document.title=`${e.title} \u2014 Cylon`;let i=Jb(e.scene),s=i!==this.looks;this.looks=i,s&&(this.reach=new Md(e.scene,e.duration));for(let r of this.pictures.values())r.setScene(e.scene,s&&t!==null);t&&t.lanes.map(Bi).join(`
`)!==e.lanes.map(Bi).join(`
`)&&this.history.clear(),this.changed()}packet(e){let{message:t}=e;if(t.type==="session"){this.take(t.session),this.payload=null;return}this.state&&t.t<this.state.t&&this.restarted(),this.state=t,this.payload=e.payload;for(let[i,s]of this.pictures)t.lanes[i]?.status==="running"&&s.read(t.t,e.payload,i)&&this.hold(s.position);for(let i of t.lanes)this.scale.see(i.contacts);this.history.add(t.t,t.lanes),this.fresh=!0}hold(e){if(this.reach?.include(e))for(let t of this.pictures.values())t.picture.frameOn(this.reach.bounds)}restarted(){this.history.clear(),this.scale.clear(),this.film.reset()}frame(e){this.rate.tick(e),this.commands.flush();let{fresh:t}=this;this.fresh=!1,t&&this.draw();for(let r of this.pictures.values())r.picture.render();let{session:i,state:s}=this;if(t&&i&&s?.playing&&Xb(i)){let r=[...this.pictures.keys()].sort((o,a)=>o-a);this.film.take(s.t,e,r.map(o=>this.pictures.get(o).picture),r.map(o=>i.lanes[o]?Bi(i.lanes[o]):""))}e-this.told>f3&&(this.told=e,this.changed())}draw(){let{state:e}=this;if(e)for(let[t,i]of this.pictures){let s=e.lanes[t];s&&i.update(e,s,this.shown,this.scale,this.anchors)}}show(e){this.shown={...this.shown,...e},this.draw(),this.changed()}attach(e,t,i){let s=new Sd(t,this.session.scene,i,this.hands);return this.camera&&(s.picture.camera=this.camera),this.reach&&s.picture.frameOn(this.reach.bounds),this.pictures.set(e,s),this.state?.lanes[e]?.status==="running"&&this.payload&&s.read(this.state.t,this.payload,e),this.fresh=!0,()=>{this.pictures.get(e)===s&&this.pictures.delete(e),s.dispose()}}hands={camera:(e,t)=>{this.camera=e;for(let i of this.pictures.values())i!==t&&(i.picture.camera=e)},frameAll:()=>{this.camera=null;for(let e of this.pictures.values())e.picture.frameAll()},grab:({body:e,anchor:t,point:i})=>{this.grabbed={body:e,anchor:t},this.anchors.set(e,t),this.pull(i)},pull:e=>this.pull(e),release:()=>{this.grabbed=null,this.send({do:"release"})}};pull(e){if(!this.grabbed||!this.session)return;let t=this.session.scene.body[this.grabbed.body]?.mass??1;this.send({do:"pull",...this.grabbed,pin:e,stiffness:Gb(t,this.pullFrequency)})}send(e){this.notice="",this.commands.put(e)}kick(e,t){let i=this.session&&md(this.session.scene,e,t?-this.kickSpeed:this.kickSpeed);i?this.send({do:"kick",body:e,impulse:i}):this.session&&e<this.session.scene.body.length&&this.tell(`${this.session.scene.body[e].name} cannot be kicked: it is locked`)}get playing(){return this.state?.playing??this.session?.playing??!1}toggle(){this.send({do:this.playing?"pause":"play"})}get speed(){return this.state?.speed??this.session?.speed??1}};function Kb({viewer:n,index:e,lane:t,state:i}){let s=Vt(null),r=Bi(t);Rt(()=>n.attach(e,s.current,`Picture of ${r}`),[n,e,r]);let o=n.session?.lanes??[],a=i&&i.status!=="running";return h("figure",{class:a?"lane broken":"lane",children:[h("figcaption",{children:[h(Ts,{style:e}),h("span",{class:"name",children:r}),i?.cpu_per_second!=null&&h("span",{class:"muted number",title:"CPU seconds per simulated second",children:[i.cpu_per_second.toPrecision(2)," CPU s/s"]}),o.length>1&&h("button",{type:"button","aria-label":`remove ${r}`,onClick:()=>n.send({do:"lanes",lanes:o.filter((l,c)=>c!==e)}),children:"\xD7"})]}),h("div",{class:"picture",ref:s}),a&&h("p",{class:"reason",role:"status",children:[h("strong",{children:i.status})," ",i.reason]})]})}function jb({value:n,label:e,check:t,send:i}){let[s,r]=lt(null),o=s===null?null:t(s),a=o&&"error"in o?o.error:"",l=()=>{o&&"value"in o&&o.value!==n&&i(o.value),a||r(null)};return h(Ze,{children:[h("input",{type:"number",step:"any",class:"number","aria-label":e,"aria-invalid":a!=="",value:s??String(n),onInput:c=>r(c.currentTarget.value),onChange:l,onBlur:()=>(l(),r(null))}),a!==""&&h("em",{class:"refused",role:"alert",children:a})]})}function p3({viewer:n,parameter:e}){let{key:t,value:i,label:s,unit:r,group:o}=e,a=l=>Yb(e,l);return typeof i=="number"?h("label",{class:"field",children:[h("span",{children:s}),h(jb,{value:i,label:`${o}: ${s}`,check:a,send:l=>n.send({do:"set",key:t,value:l})}),h("span",{class:"muted",children:r})]}):h("div",{class:"field vector",role:"group","aria-label":s,children:[i.map((l,c)=>h(jb,{value:l,label:`${s}, ${"xyz"[c]}`,check:a,send:u=>n.send({do:"set",key:t,value:i.map((f,d)=>d===c?u:f)})},c)),h("span",{class:"muted",children:r})]})}function m3(n){let e=new Map;for(let t of qb(n)){let[i]=/^(spring|drag|attraction|water|material)\.\d+/.exec(t.key)??[t.group],s=e.get(i);s?s.push(t):e.set(i,[t])}return[...e.values()]}var ba=60;function Qb({viewer:n,scene:e}){let t=He(()=>m3(e),[e]);return h("section",{class:"panel",children:[h("h2",{children:"Scene"}),t.slice(0,ba).map((i,s)=>h("details",{open:s<3&&i.length<8,children:[h("summary",{children:i[0].group}),i.slice(0,ba).map(r=>h(p3,{viewer:n,parameter:r},r.key)),i.length>ba&&h("p",{class:"muted",children:["and ",i.length-ba," more"]})]},`${s} ${i[0].group}`)),t.length>ba&&h("p",{class:"muted",children:["and ",t.length-ba," more groups"]})]})}var eS=170;function g3(n,e,t){let i={stroke:()=>si("--ink"),grid:{stroke:()=>si("--line"),width:1},ticks:{stroke:()=>si("--line"),width:1},font:"12px system-ui, sans-serif",labelFont:"12px system-ui, sans-serif",labelSize:16,labelGap:0};return{width:n,height:eS,legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1},y:{range:(s,r,o)=>Vb(r,o)}},axes:[{...i,label:"time [s]",size:30},{...i,label:`[${t}]`,size:(s,r)=>30+7*Math.max(3,...(r??[]).map(o=>o.length)),values:(s,r)=>r.map(o=>String(Number(o.toPrecision(7))))}],series:[{},...e.map((s,r)=>({stroke:()=>si(Hi(r).color),dash:Hi(r).dash,width:2,points:{show:!1}}))]}}function _3({viewer:n,lanes:e,quantity:t}){let i=Vt(null),[s,r]=lt("size"),o=e.map(Bi).join(`
`);Rt(()=>{let u=i.current,f=new En(g3(Math.max(u.clientWidth,160),e,pd[t]),[[],...e.map(()=>[])],u),d=null,p=()=>{let{samples:_}=n.history,g=_[_.length-1];g===d&&_.length>0||(d=g,f.setData([n.history.times(),...e.map((y,E)=>n.history.series(E,t,s))]))};p();let m=[n.subscribe(p),So(()=>f.redraw())],v=new ResizeObserver(()=>f.setSize({width:Math.max(u.clientWidth,160),height:eS}));return v.observe(u),()=>{for(let _ of m)_();v.disconnect(),f.destroy()}},[n,o,t,s]);let a=n.history.samples[n.history.samples.length-1],l=u=>a?.lanes[u]?ar(n.history.series(u,t,s).at(-1)):"",c=e.map((u,f)=>`${Bi(u)} ${l(f)}`);return h("figure",{class:"rolling",children:[h("figcaption",{children:[t,t!=="energy"&&h("select",{"aria-label":`component of ${t}`,value:s,onChange:u=>r(u.currentTarget.value),children:Bb.map(u=>h("option",{value:u,children:u},u))})]}),h("div",{ref:i,role:"img","aria-label":`${t} over time: ${c.join(", ")}`})]})}function tS({viewer:n,lanes:e}){return h("div",{class:"plots",children:Ob.map(t=>h(_3,{viewer:n,lanes:e,quantity:t},t))})}var nS=[{quantity:"energy",component:"size",name:"E"},...["momentum","angular momentum"].flatMap(n=>["size","x","y","z"].map(e=>{let t=n==="momentum"?"p":"L";return{quantity:n,component:e,name:e==="size"?`|${t}|`:`${t} ${e}`}}))];function x3(n,e){return!n||n.energy==null||e.energy==null?"\u2013":ar(e.energy-n.energy)}function iS({viewer:n,lanes:e}){let t=n.state?.lanes??[],i=n.history.first?.lanes;return h("div",{class:"wide",tabIndex:0,role:"region","aria-label":"totals",children:h("table",{class:"readout",children:[h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"lane"}),h("th",{scope:"col",children:"contacts"}),h("th",{scope:"col",children:["E \u2212 E\u2080 ",h("span",{class:"muted",children:"[J]"})]}),nS.map(({quantity:s,name:r})=>h("th",{scope:"col",children:[r," ",h("span",{class:"muted",children:["[",pd[s],"]"]})]},r))]})}),h("tbody",{children:e.map((s,r)=>{let o=t[r],a=o?.status==="running";return h("tr",{children:[h("th",{scope:"row",children:[h(Ts,{style:r})," ",Bi(s)]}),h("td",{class:"number",children:o&&a?o.contacts.length:"\u2013"}),h("td",{class:"number",children:o&&a?x3(i?.[r],o):"\u2013"}),nS.map(({quantity:l,component:c,name:u})=>h("td",{class:"number",children:o&&a?ar(Im(o,l,c)):"\u2013"},u))]},`${r} ${Bi(s)}`)})})]})})}var y3=[{name:"velocity",label:"Velocity",key:"V",unit:"m/s"},{name:"momentum",label:"Momentum",key:"M",unit:"kg m/s"},{name:"angular momentum",label:"Angular momentum",key:"L",unit:"kg m\xB2/s"},{name:"trails",label:"Trails",key:"T"},{name:"contacts",label:"Contacts, impulses",key:"C",unit:"N s"},{name:"links",label:"Springs, joints",key:"J"}],v3=(n,e)=>e==="contacts"?n.scale.impulse:n.scale.of(e);function sS({viewer:n}){return h("section",{class:"panel",children:[h("h2",{children:"Show"}),h("div",{class:"choices",children:y3.map(({name:e,label:t,key:i,unit:s})=>h("label",{children:[h("input",{type:"checkbox",checked:n.shown[e],onChange:r=>n.show({[e]:r.currentTarget.checked})}),t," ",h("kbd",{children:i}),s&&n.shown[e]&&h("span",{class:"muted number",children:[" ","longest ",ar(v3(n,e))," ",s]})]},e))})]})}var b3=n=>Math.log10(n),S3=n=>Number((10**n).toPrecision(3));function rS({viewer:n,session:e}){let{state:t,speed:i,playing:s,connected:r}=n,o=t?.t??0,a=n.rate.perSecond;return h("section",{class:"transport","aria-label":"time",children:[h("button",{type:"button",class:"play",disabled:!r,onClick:()=>n.toggle(),children:s?"Pause":"Play"}),h("button",{type:"button",disabled:!r,onClick:()=>n.send({do:"step"}),children:"Step"}),h("button",{type:"button",disabled:!r,onClick:()=>n.send({do:"reset"}),children:"Reset"}),h("label",{class:"speed",children:["Speed",h("input",{type:"range",min:-2,max:2,step:.05,value:b3(i),"aria-valuetext":`${i} simulated seconds per second`,onInput:l=>n.send({do:"speed",value:S3(Number(l.currentTarget.value))})}),h("output",{class:"number",children:[i.toPrecision(3),"\xD7"]})]}),h("p",{class:"clock",children:[h("span",{class:"number",children:["t = ",o.toFixed(4)," s"]}),h("span",{class:"muted",children:[o>e.duration?" past the scenario\u2019s ":" of ",e.duration," s"]})]}),h("p",{class:"rate muted number","data-testid":"rate",children:[a.toFixed(0)," fps \xB7 ",e.scene.body.length," ",e.scene.body.length===1?"body":"bodies"]}),e.recording!==""&&h("p",{class:"recording",children:["\u25CF recording to ",e.recording]})]})}function oS(n){let[,e]=lt(0);Rt(()=>n.subscribe(()=>e(t=>t+1)),[n])}function M3({viewer:n}){let{connected:e,why:t,notice:i}=n;return h("div",{class:"banners",role:"alert",children:[!e&&h("p",{class:"banner gone",children:["No connection to the server: ",t,". The page tries again by itself."]}),e&&i!==""&&h("p",{class:"banner notice",children:[i,h("button",{type:"button",onClick:()=>n.tell(""),"aria-label":"close this message",children:"\xD7"})]})]})}function aS({viewer:n}){oS(n);let e=Vt(null);Rt(()=>{let s=Ub(n,()=>e.current?.open?e.current.close():e.current?.showModal());return addEventListener("keydown",s),()=>removeEventListener("keydown",s)},[n]);let{session:t,state:i}=n;return h(Ze,{children:[h("header",{class:"head",children:[h("h1",{children:t?.title??"Cylon"}),t&&h("details",{class:"story",children:[h("summary",{children:t.scenario}),h("p",{children:t.story})]}),h("button",{type:"button",onClick:()=>e.current?.showModal(),children:["Keys ",h("kbd",{children:"?"})]})]}),h(M3,{viewer:n}),t&&h("main",{class:"viewer",children:[h(rS,{viewer:n,session:t}),h("section",{class:`lanes of-${Math.min(t.lanes.length,4)}`,"aria-label":"pictures",children:t.lanes.map((s,r)=>h(Kb,{viewer:n,index:r,lane:s,state:i?.lanes[r]},`${r} ${Bi(s)}`))}),h("div",{class:"numbers",children:[h(iS,{viewer:n,lanes:t.lanes}),h(tS,{viewer:n,lanes:t.lanes})]}),h("aside",{class:"panels","aria-label":"settings",children:[h(sS,{viewer:n}),h(Hb,{viewer:n,scene:t.scene}),h(Qb,{viewer:n,scene:t.scene}),h(Wb,{viewer:n,session:t})]})]}),h(kb,{dialog:e})]})}function lS(n){ec();let e=new wd;n.replaceChildren(),La(h(aS,{viewer:e}),n),e.start()}var w3={report:Nb,view:lS},cS=document.getElementById("app"),uS=w3[document.documentElement.dataset.page??""];cS&&uS&&uS(cS);})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
